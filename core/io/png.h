// PNG, 8-bit RGBA, through stb (other depths and palettes are converted on reading).
#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

// Largest edge in pixels, read or written.
inline constexpr int kMaxPngEdge = 16384;

// Checks the sizes, the checksum of every chunk and how much the packed pixels unfold to before
// memory for them is taken.
[[nodiscard]] Result<Image> readPng(ByteView bytes);
// The same picture gives the same bytes. Fails when the picture is empty or too large.
[[nodiscard]] Result<Bytes> writePng(const Image& image);
[[nodiscard]] Result<Image> readPngFile(const std::filesystem::path& path);
[[nodiscard]] Status writePngFile(const std::filesystem::path& path, const Image& image);

}  // namespace voxprite
