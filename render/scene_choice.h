// By what the entities of a scene are drawn, chosen before the scene is: what a model offers beside
// its exact sprite, how large it shows, and the entity that a choice makes of it.
#pragma once

#include <optional>
#include <vector>

#include "core/lod/model_levels.h"
#include "core/lod/representation.h"
#include "core/sprite/view_set.h"
#include "render/cluster_renderer.h"
#include "render/scene_renderer.h"

namespace voxprite {

// A model's levels on the GPU. Owned by whoever owns the model, and good for one revision of it.
struct GpuModelLevels {
    glm::ivec3 origin{0};
    glm::ivec3 size{0};
    std::vector<GpuOctree> coarse;  // [k] leaves k + 1 levels out
    GpuClusters clusters;

    GpuModelLevels() = default;
    explicit GpuModelLevels(const ModelLevels& levels);  // uploads them
    [[nodiscard]] bool offers(RepresentationChoice choice) const;
};

// What a model with these levels can be drawn by; the exact sprite first.
[[nodiscard]] std::vector<RepresentationChoice> choicesOf(const GpuModelLevels& levels);

// The radius of the sphere around the model's box in screen pixels, at the depth of its centre;
// NaN when that is not ahead of the camera.
[[nodiscard]] double representationSizePx(const PlacedEntity& placed, const Camera& camera);

// `exact` drawn by `choice`, or as it is when the model does not offer that; without levels, or
// with those of a model of another size, it has snapshots alone. The levels and the views are read
// as long as the entity is drawn.
[[nodiscard]] SceneEntity drawnBy(const SceneEntity& exact, RepresentationChoice choice,
                                  const GpuModelLevels* levels, const ViewSet& views);

}  // namespace voxprite
