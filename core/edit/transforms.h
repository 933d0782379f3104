// Moving, turning, flipping and scaling voxels, as placements (exact, invertible) where possible.
#pragma once

#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/edit/clip.h"
#include "core/model/placement.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

[[nodiscard]] Placement translation(glm::ivec3 byVoxels);

// Counter-clockwise seen from the positive end of `axis`; any number of turns, negative ones too.
[[nodiscard]] SignedPermutation quarterTurns(int axis, int turns);
[[nodiscard]] SignedPermutation flip(int axis);

// `rotation` carried out in place on what fills `box`: about its centre or, where that would leave
// the lattice by half a voxel, beside it. Repeated on its own results, four quarter turns and two
// flips lead back exactly.
[[nodiscard]] Placement inPlace(const SignedPermutation& rotation, const IBox& box);

// The same for a clip: its bounds() are the box.
void turn(VoxelClip& clip, int axis, int turns);
void flip(VoxelClip& clip, int axis);
void moveBy(VoxelClip& clip, glm::ivec3 byVoxels);
// Every voxel becomes a cube of `factor` voxels; the minimum corner of the bounds stays. Fails for
// factors below 1, beyond the range of coordinates and beyond kMaxPatchVoxels.
[[nodiscard]] Status scale(VoxelClip& clip, int factor);

// What would lie beyond the range of coordinates is left out.
[[nodiscard]] VoxelGrid transformed(const VoxelGrid& voxels, const Placement& placement);
[[nodiscard]] VoxelSet transformed(const VoxelSet& set, const Placement& placement);

}  // namespace voxprite
