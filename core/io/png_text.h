// Chunks of a PNG that pictures do not need: texts of our own (tEXt), and the putting together of
// chunks for them and for animations.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"

namespace voxprite {

// Everything in a PNG is big-endian.
void putBigEndian(Bytes& bytes, std::uint32_t value, int count);
void appendPngChunk(Bytes& file, std::string_view type, ByteView content);

inline constexpr std::size_t kPngSignatureBytes = 8;
inline constexpr std::size_t kPngHeaderBytes = 25;  // of the chunk IHDR, which follows

// The picture with a text behind its header. `png` comes from writePng(); `key` and `text` are
// Latin-1 without zeros, the key of 1 to 79 bytes.
[[nodiscard]] Bytes withPngText(ByteView png, std::string_view key, std::string_view text);
// The first text of this key before the pixels, of a file that readPng() takes.
[[nodiscard]] std::optional<std::string> pngText(ByteView png, std::string_view key);

}  // namespace voxprite
