// All that a model can be drawn by beside its exact sprite, made from its octree: coarser octrees
// and clusters. (Snapshots are sprites, and are made as they are shown.)
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/lod/cluster_mesh.h"
#include "core/svo/octree.h"

namespace voxprite {

inline constexpr int kMostCoarseLevels = 3;

// How many levels of the octree a model of this size has to leave out: as many as leave the longest
// edge four cells, and no more than kMostCoarseLevels.
[[nodiscard]] int coarseLevelsOf(glm::ivec3 size);

struct ModelLevels {
    glm::ivec3 origin{0};  // of the model itself, and its size
    glm::ivec3 size{0};
    // [k] leaves k + 1 levels out; coarseLevelsOf(size) of them.
    std::vector<Octree> coarse;
    ClusterMesh clusters;  // empty where buildClusters() fails: too deep, or too large a surface
};

// On any thread; the result depends on the octree alone. Fails as coarsen() does.
[[nodiscard]] Result<ModelLevels> buildModelLevels(const Octree& model, int threads = 0);

}  // namespace voxprite
