// Puts PNG files together by hand, right or wrong, without any code of the reader or writer.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/bytes.h"

namespace voxprite::test {

// Big-endian chunk with its checksum.
void putPngChunk(Bytes& png, const std::string& id, const Bytes& content);
// zlib data that is stored and not packed; at most 65535 bytes.
[[nodiscard]] Bytes storedZlib(const Bytes& bytes);
// `rows` as they are packed: before each row a byte for its filter, 0.
[[nodiscard]] Bytes handmadePng(std::uint8_t width, std::uint8_t height, std::uint8_t depth,
                                std::uint8_t type, const Bytes& rows, const Bytes& palette = {},
                                const Bytes& transparency = {});

}  // namespace voxprite::test
