// PNG, 8-bit RGBA, through stb (other depths are converted on reading).
#pragma once

#include <filesystem>

#include "core/base/bytes.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

[[nodiscard]] Result<Image> readPng(ByteView bytes);
[[nodiscard]] Result<Bytes> writePng(const Image& image);
[[nodiscard]] Result<Image> readPngFile(const std::filesystem::path& path);
[[nodiscard]] Status writePngFile(const std::filesystem::path& path, const Image& image);

}  // namespace voxprite
