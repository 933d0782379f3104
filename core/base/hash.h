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

template <class T>
[[nodiscard]] ByteView asBytes(const std::vector<T>& values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace voxprite
