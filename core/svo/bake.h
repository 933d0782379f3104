// Voxels -> canonical octree.
#pragma once

#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite {

// Bakes what lies inside `bounds` (entity space); bounds.min becomes voxel (0,0,0). Frames of one
// entity are all baked with the entity's bounds. Fails when an edge exceeds 65,536 voxels or the
// octree needs more than kMaxOctreeNodes nodes.
[[nodiscard]] Result<Octree> bake(const VoxelGrid& voxels, const IBox& bounds);
// With the tight bounds of the voxels themselves.
[[nodiscard]] Result<Octree> bake(const VoxelGrid& voxels);

// The voxels again, at octree.origin.
[[nodiscard]] VoxelGrid toVoxels(const Octree& octree);

}  // namespace voxprite
