// Shells, growth and smoothing of voxels. What is inside and outside is decided by solidity alone;
// new voxels take a colour from those they grew from. Layers are counted through faces, so that a
// single voxel dilates to an octahedron.
#pragma once

#include "core/base/result.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

inline constexpr int kMaxMorphologyLayers = 64;

// All fail unless 1 <= layers (or wall, or passes) <= kMaxMorphologyLayers.

// `layers` more all around. A new voxel takes the colour of one of its nearest solid voxels: layer
// by layer that which most of its faces touch, of several the lowest index. Fails as well when that
// reaches beyond the range of coordinates.
[[nodiscard]] Result<VoxelGrid> dilated(const VoxelGrid& voxels, int layers);
// Without the outermost `layers`, those around inner holes included.
[[nodiscard]] Result<VoxelGrid> eroded(const VoxelGrid& voxels, int layers);
// Only what erosion by `wall` layers would take away.
[[nodiscard]] Result<VoxelGrid> hollowed(const VoxelGrid& voxels, int wall);
// A majority vote, `passes` times: a voxel is solid when at least 14 of the 27 voxels of the cube
// of 3 around it are. Flat faces stay; corners and edges are rounded, pits fill, and what is one
// voxel thin goes away. A new voxel takes the most frequent colour of that cube, of several the
// lowest index.
[[nodiscard]] Result<VoxelGrid> smoothed(const VoxelGrid& voxels, int passes);

}  // namespace voxprite
