// The open faces of a model as few rectangles: what meshes are written from.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// Models with more are refused, before memory for them is taken.
inline constexpr std::size_t kMaxOpenFaces = std::size_t{1} << 25;

// A rectangle of faces of one palette index that look one way. Space: the model's, whose corners
// are whole numbers; min equals max along the face's axis.
struct VoxelQuad {
    glm::ivec3 min{0};
    glm::ivec3 max{0};
    std::uint8_t material = 0;  // 1 ... 255
    std::uint8_t face = 0;      // the outward normal: 0 +x, 1 +y, 2 +z, 3 -x, 4 -y, 5 -z
    bool operator==(const VoxelQuad&) const = default;
};

// Together exactly the faces between a solid voxel and an empty one, each once. Greedy within
// squares of 1,024 faces (core/lod/greedy_rectangles.h); in the order of face, layer, square. The
// edges of neighbours need not share corners: a corner may lie on another's edge, exactly.
[[nodiscard]] Result<std::vector<VoxelQuad>> openQuads(const VoxelGrid& voxels);

}  // namespace voxprite
