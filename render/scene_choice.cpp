#include "render/scene_choice.h"

#include <glm/geometric.hpp>
#include <limits>

#include "core/sprite/coarse_entity.h"

namespace voxprite {

GpuModelLevels::GpuModelLevels(const ModelLevels& levels)
    : origin(levels.origin), size(levels.size) {
    for (const Octree& octree : levels.coarse) coarse.emplace_back().upload(octree.view());
    clusters.upload(levels.clusters);
}

bool GpuModelLevels::offers(RepresentationChoice choice) const {
    switch (choice.kind) {
        case Representation::sprite:
        case Representation::snapshot:
            return true;
        case Representation::clusters:
            return clusters.indexCount() > 0;
        case Representation::coarse:
            return choice.levels >= 1 && choice.levels <= static_cast<int>(coarse.size());
    }
    return false;
}

std::vector<RepresentationChoice> choicesOf(const GpuModelLevels& levels) {
    std::vector<RepresentationChoice> choices{{Representation::sprite, 0},
                                              {Representation::snapshot, 0}};
    if (levels.clusters.indexCount() > 0) choices.push_back({Representation::clusters, 0});
    for (int left = 1; left <= static_cast<int>(levels.coarse.size()); ++left) {
        choices.push_back({Representation::coarse, left});
    }
    return choices;
}

double representationSizePx(const PlacedEntity& placed, const Camera& camera) {
    const double depth = glm::dot(placed.centreMetres() - camera.eyeMetres, camera.forward);
    if (!(depth > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return placed.radiusMetres() / camera.metresPerScreenPx(depth);
}

SceneEntity drawnBy(const SceneEntity& exact, RepresentationChoice choice,
                    const GpuModelLevels* levels, const ViewSet& views) {
    SceneEntity entity = exact;
    if (choice.kind == Representation::snapshot) {
        entity.representation = choice.kind;
        entity.views = &views;
    }
    const bool own = levels != nullptr && levels->size == exact.octree->size();
    if (!own || !levels->offers(choice)) return entity;
    entity.representation = choice.kind;
    if (choice.kind == Representation::clusters) entity.clusters = &levels->clusters;
    if (choice.kind == Representation::coarse) {
        entity.octree = &levels->coarse[static_cast<std::size_t>(choice.levels - 1)];
        entity.placed = coarseEntity(exact.placed, levels->origin, choice.levels);
    }
    return entity;
}

}  // namespace voxprite
