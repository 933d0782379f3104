// A ZIP in memory, through libzip. Private to core/io.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

struct zip;

namespace voxprite {

struct ZipEntry {
    std::string name;
    Bytes bytes;
};

// Deflated, in the order given, without times or attributes: equal entries give equal bytes.
[[nodiscard]] Result<Bytes> writeZip(const std::vector<ZipEntry>& entries);

class ZipReader {
  public:
    // `bytes` must outlive the reader.
    [[nodiscard]] static Result<ZipReader> open(ByteView bytes);

    // Inflates one entry, whose CRC-32 must be right. The size it claims must be within `maxBytes`
    // and within what its compressed bytes can hold; both are checked before memory is taken.
    [[nodiscard]] Result<Bytes> read(const std::string& name, std::uint64_t maxBytes) const;

  private:
    struct Close {
        void operator()(zip* archive) const;
    };
    explicit ZipReader(zip* archive) : archive_(archive) {}
    std::unique_ptr<zip, Close> archive_;
};

}  // namespace voxprite
