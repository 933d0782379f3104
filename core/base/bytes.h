// Bounded little-endian reading and writing of byte strings. Every binary format goes through here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace voxprite {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

// Reads forward through a view that it does not own. A read past the end fails with the offset and
// leaves the position where it was; nothing is ever read out of bounds.
class ByteReader {
  public:
    // `base` is the offset of `bytes[0]` in the file, so that errors name the place in the file.
    explicit ByteReader(ByteView bytes, std::uint64_t base = 0) : bytes_(bytes), base_(base) {}

    [[nodiscard]] std::uint64_t offset() const { return base_ + position_; }
    [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }
    [[nodiscard]] bool atEnd() const { return remaining() == 0; }

    // `what` names the value in the error: "byte 12: the file ends inside <what>".
    [[nodiscard]] Result<std::uint8_t> u8(std::string_view what);
    [[nodiscard]] Result<std::uint16_t> u16(std::string_view what);
    [[nodiscard]] Result<std::uint32_t> u32(std::string_view what);
    [[nodiscard]] Result<std::uint64_t> u64(std::string_view what);
    [[nodiscard]] Result<std::int32_t> i32(std::string_view what);
    [[nodiscard]] Result<double> f64(std::string_view what);
    // The next `count` bytes, still owned by whoever owns the view.
    [[nodiscard]] Result<ByteView> take(std::uint64_t count, std::string_view what);
    // A reader over the next `count` bytes that reports offsets of the whole file.
    [[nodiscard]] Result<ByteReader> sub(std::uint64_t count, std::string_view what);
    // A u32 length followed by that many bytes.
    [[nodiscard]] Result<std::string> string32(std::string_view what);

  private:
    ByteView bytes_;
    std::uint64_t base_ = 0;
    std::size_t position_ = 0;
};

class ByteWriter {
  public:
    void u8(std::uint8_t value);
    void u16(std::uint16_t value);
    void u32(std::uint32_t value);
    void u64(std::uint64_t value);
    void i32(std::int32_t value);
    void f64(double value);
    void raw(ByteView bytes);
    void raw(std::string_view text);
    void string32(std::string_view text);
    // Zero bytes until size() is a multiple of `alignment`.
    void alignTo(std::size_t alignment);
    // Overwrites four bytes written before (a length that is known only now).
    void patchU32(std::size_t at, std::uint32_t value);

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] const Bytes& bytes() const { return bytes_; }
    [[nodiscard]] Bytes release() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

}  // namespace voxprite
