#include "app/trade/model_parts.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/lod/model_levels.h"
#include "core/sprite/coarse_entity.h"
#include "core/svo/coarsen.h"

namespace voxprite::trade {

ModelParts::ModelParts(std::shared_ptr<const Model> model, const GameProfile& profile)
    : model_(std::move(model)) {
    const glm::ivec3 origin = model_->octree.origin;
    placed_ = placeEntity(model_->entity, IBox{origin, origin + model_->octree.size}, profile);
    placed_.anchorMetres -= placed_.centreMetres();
    const glm::ivec3 size = model_->octree.size;
    mostLevels_ = coarseLevelsOf(size);
}

Result<const ModelParts::Coarse*> ModelParts::coarse(int levels) {
    const auto known = coarse_.find(levels);
    if (known != coarse_.end()) return &known->second;
    const Stopwatch watch;
    Result<Octree> octree = coarsen(model_->octree, levels);
    if (!octree) return Failure(octree.error());
    Coarse made{std::move(*octree), coarseEntity(placed_, model_->octree.origin, levels),
                watch.milliseconds()};
    return &coarse_.emplace(levels, std::move(made)).first->second;
}

Result<const ModelParts::Clusters*> ModelParts::clusters() {
    if (clusters_) return clusters_.get();
    const Stopwatch watch;
    Result<ClusterMesh> mesh = buildClusters(model_->octree.view());
    if (!mesh) return Failure(mesh.error());
    clusters_ = std::make_unique<Clusters>(Clusters{std::move(*mesh), watch.milliseconds()});
    return clusters_.get();
}

std::uint64_t bytesOf(const OctreeView& octree) {
    return octree.nodes.size_bytes() + octree.payloads.size_bytes();
}

}  // namespace voxprite::trade
