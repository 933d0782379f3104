// Checksums and fingerprints, by libraries: SHA-256 (OpenSSL) for pictures and tests, CRC-32
// (zlib: polynomial 0xEDB88320, the one of PNG and ZIP) inside files.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/bytes.h"

namespace voxprite {

// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256Hex(ByteView bytes);
[[nodiscard]] std::uint32_t crc32(ByteView bytes);

// Whether readers compare checksums. True; a fuzz target links a definition of its own that says
// no (tests/fuzz/checksums.cpp): none of its mutations would come past one, and everything behind
// it must withstand them just the same.
extern const bool kChecksumsCount;

template <class T, class Allocator>
[[nodiscard]] ByteView asBytes(const std::vector<T, Allocator>& values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace voxprite
