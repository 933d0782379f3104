// The rival of the integer lattice: the sprite specification's walk (seed 001, section 7) as
// shaders usually have it. Kept to be measured, never to be drawn with.
#pragma once

#include <array>

#include "core/svo/octree.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::trade {

// In fp32: the inverse of the direction, the octree entered anew from its root for every node, and
// an epsilon past each face. `origin` in voxels.
[[nodiscard]] LatticeHit castFp32Walk(const OctreeView& octree, const std::array<float, 3>& origin,
                                      const std::array<float, 3>& direction);

}  // namespace voxprite::trade
