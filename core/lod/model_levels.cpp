#include "core/lod/model_levels.h"

#include <algorithm>

#include "core/svo/coarsen.h"

namespace voxprite {

namespace {

constexpr int kLeastEdgeCells = 4;

}  // namespace

int coarseLevelsOf(glm::ivec3 size) {
    const int longest = std::max({size.x, size.y, size.z});
    int levels = 0;
    while (levels < kMostCoarseLevels && longest >> (levels + 1) >= kLeastEdgeCells) ++levels;
    return levels;
}

Result<ModelLevels> buildModelLevels(const Octree& model, int threads) {
    ModelLevels built;
    built.origin = model.origin;
    built.size = model.size;
    for (int levels = 1; levels <= coarseLevelsOf(model.size); ++levels) {
        Result<Octree> coarse = coarsen(model, levels);
        if (!coarse) return Failure(coarse.error());
        built.coarse.push_back(std::move(*coarse));
    }
    ClusterBuildOptions options;
    options.threads = threads;
    if (Result<ClusterMesh> clusters = buildClusters(model.view(), options)) {
        built.clusters = std::move(*clusters);
    }
    return built;
}

}  // namespace voxprite
