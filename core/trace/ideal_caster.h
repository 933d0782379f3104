// The yardstick: the same parallel ray without quantisation, in long double, walking every cell.
// Slow; for tests and for measuring the integer caster's error.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/svo/octree.h"
#include "core/trace/lattice.h"
#include "core/trace/lattice_caster.h"

namespace voxprite {

// The hit of sample (i, j) of `view`, sampled where quantiseView says, before rounding.
[[nodiscard]] LatticeHit castIdeal(const OctreeView& octree, const OrthoView& view,
                                   glm::ivec2 pixel);

}  // namespace voxprite
