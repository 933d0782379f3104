// What a sheet shows of one sprite beside its colours. All have the alpha of the sprite.
#pragma once

#include "core/base/image.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/octree.h"

namespace voxprite {

// The faces' normals toward (right, up, the eye): 0 ... 255 for -1 ... 1. The outline looks to the
// eye.
[[nodiscard]] Image normalsOf(const SpriteBuffer& buffer, const SpriteView& view,
                              const OctreeView& octree);
// Grey: 255 so many metres before the model's centre, 0 as many behind it.
[[nodiscard]] Image depthsOf(const SpriteBuffer& buffer, const SpriteView& view,
                             const OctreeView& octree, double rangeMetres);
// Grey: the palette index of the voxel; the outline 0.
[[nodiscard]] Image indicesOf(const SpriteBuffer& buffer, const SpriteView& view,
                              const OctreeView& octree);

}  // namespace voxprite
