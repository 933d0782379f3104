// The voxels themselves in perspective (or orthographic), in the sprite's own light: an eye ray
// through the middle of each pixel. What the style of sprites is compared with.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/image.h"
#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/svo/octree.h"

namespace voxprite {

// Row by row from the top.
struct PerspectivePicture {
    Image image;
    std::vector<std::uint32_t> ids;     // kIdEmpty or kIdFirstVoxel + index, see sprite_buffer.h
    std::vector<float> reversedDepths;  // Camera::reversedDepth; 0 where nothing is
};

// Each face has exactly the colour that a sprite gives it, occlusion and shadow included. Of the
// octree `maxDepth` levels are looked at (RaycastOptions). threads <= 0: all cores.
[[nodiscard]] PerspectivePicture perspectivePicture(
    const OctreeView& octree, const Palette& palette, const PlacedEntity& placed,
    const Light& light, Shading shading, const Camera& camera, Rgba8 background = Rgba8(0),
    int maxDepth = kMaxOctreeDepth, int threads = 0);

}  // namespace voxprite
