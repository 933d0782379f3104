#include "core/sprite/coarse_entity.h"

namespace voxprite {

PlacedEntity coarseEntity(const PlacedEntity& fine, glm::ivec3 origin, int levels) {
    const double voxelsPerCell = static_cast<double>(1 << levels);
    // What the first cell adds before the model.
    const glm::ivec3 before = origin - ((origin >> levels) << levels);
    PlacedEntity coarse = fine;
    coarse.scale = fine.scale * voxelsPerCell;
    coarse.anchor = (fine.anchor + glm::dvec3(before)) / voxelsPerCell;
    if (fine.modelSize == glm::ivec3(0)) return coarse;
    coarse.modelSize = ((fine.modelSize + before - 1) >> levels) + 1;
    coarse.centreFromMiddle = (fine.centreVoxels() + glm::dvec3(before)) / voxelsPerCell -
                              glm::dvec3(coarse.modelSize) * 0.5;
    return coarse;
}

}  // namespace voxprite
