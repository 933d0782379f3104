// Fields of .vox chunks: 32-bit numbers, strings and dictionaries, read within the chunk's bounds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/palette.h"

namespace voxprite {

// Reads the fields of one chunk. The first failure sticks: every later read gives zero or nothing,
// so that a chunk is read in one go and asked once whether it was whole.
class VoxFields {
  public:
    explicit VoxFields(ByteReader reader) : reader_(reader) {}

    [[nodiscard]] std::uint8_t u8(std::string_view what);
    [[nodiscard]] std::int32_t i32(std::string_view what);
    [[nodiscard]] float f32(std::string_view what);
    // How many entries follow; fails unless that many, at `bytesEach` or more, can still follow.
    [[nodiscard]] std::uint32_t count(std::size_t bytesEach, std::string_view what);
    // A string; bytes that are not UTF-8 are taken as Latin-1.
    [[nodiscard]] std::string text(std::string_view what);
    [[nodiscard]] Properties properties(std::string_view what);
    [[nodiscard]] ByteView take(std::uint64_t bytes, std::string_view what);

    [[nodiscard]] std::uint64_t offset() const { return reader_.offset(); }
    [[nodiscard]] std::size_t remaining() const { return reader_.remaining(); }
    [[nodiscard]] bool ok() const { return !error_; }
    // Makes this the failure, unless there is an earlier one.
    void refuse(std::uint64_t offset, std::string message);
    [[nodiscard]] Status status() const;

  private:
    template <class T>
    T kept(Result<T> value, std::string_view what) {
        if (value) return *value;
        refuse(offset(), "the chunk ends inside " + std::string(what));
        return T{};
    }

    ByteReader reader_;
    std::optional<Error> error_;
};

// The text itself where it is UTF-8, else each of its bytes as the Latin-1 character.
[[nodiscard]] std::string utf8FromBytes(std::string_view bytes);

// A decimal number that is the whole of `text`.
[[nodiscard]] std::optional<int> wholeNumber(std::string_view text);

void writeProperties(ByteWriter& out, const Properties& properties);

// Takes `key` out of `properties`; nothing where it is not there.
[[nodiscard]] std::optional<std::string> takeProperty(Properties& properties,
                                                      const std::string& key);
// The same for a switch: "1" is on.
[[nodiscard]] bool takeSwitch(Properties& properties, const std::string& key);

// Writes a chunk without children around what `body` writes.
template <class Body>
void writeChunk(ByteWriter& out, std::string_view id, Body&& body) {
    out.raw(id);
    const std::size_t lengths = out.size();
    out.u32(0);
    out.u32(0);
    body();
    out.patchU32(lengths, static_cast<std::uint32_t>(out.size() - lengths - 8));
}

}  // namespace voxprite
