// What the artist has selected: a VoxelSet of solid voxels of one model. These functions make
// selections; combined() adds to, takes from or narrows the one there is. connectedRegion() and
// voxelsOfColour() (regions.h) are the magic wands.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/base/box.h"
#include "core/edit/voxel_set.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

enum class SelectMode : std::uint8_t { replace, add, remove, intersect };

[[nodiscard]] VoxelSet combined(VoxelSet selection, const VoxelSet& with, SelectMode mode);

[[nodiscard]] VoxelSet selectAll(const VoxelGrid& voxels);
[[nodiscard]] VoxelSet selectBox(const VoxelGrid& voxels, const IBox& box);
// Where dot(normal, p) >= offset, p in continuous model space.
struct HalfSpace {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
};
// The solid voxels whose middles lie in all of these: what a rectangle on the screen goes through.
// Whole blocks are decided at once where no plane runs through them.
[[nodiscard]] VoxelSet selectInside(const VoxelGrid& voxels, std::span<const HalfSpace> sides);
// The solid voxels that are not selected.
[[nodiscard]] VoxelSet inverted(const VoxelGrid& voxels, const VoxelSet& selection);
// Drops what is no longer solid, after an edit or an undo.
[[nodiscard]] VoxelSet stillSolid(const VoxelGrid& voxels, VoxelSet selection);

}  // namespace voxprite
