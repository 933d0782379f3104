// bake() on a number of threads of one's own choice.
#pragma once

#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite {

// The same octree on any number of threads; 0 are as many as pay for a model of its size, which is
// what bake() takes.
[[nodiscard]] Result<Octree> bakeOnThreads(const VoxelGrid& voxels, const IBox& bounds,
                                           int threads);

}  // namespace voxprite
