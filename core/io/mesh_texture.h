// Pictures that meshes are painted with: PNG and JPEG.
#pragma once

#include "core/base/bytes.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

// Pixels of all textures of a mesh together.
inline constexpr std::uint64_t kMaxTexturePixels = std::uint64_t{1} << 27;

// By the first bytes. Refuses pictures of more than `mostPixels`, before memory for them is taken,
// and JPEG that has fewer bytes than its pixels need.
[[nodiscard]] Result<Image> readTexture(ByteView bytes, std::uint64_t mostPixels);

}  // namespace voxprite
