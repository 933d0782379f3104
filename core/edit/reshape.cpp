#include "core/edit/reshape.h"

#include "core/edit/selection.h"

namespace voxprite {

Result<VoxelPatch> patchCrop(const Document& document, int model, const VoxelSet& keep) {
    return patchSet(document, model, inverted(document.voxelsOf(model), keep), EditMode::erase, 0);
}

glm::ivec3 offsetToCentre(const IBox& bounds) {
    if (bounds.empty()) return glm::ivec3(0);
    const glm::ivec3 half = bounds.size() / 2;
    return {-half.x - bounds.min.x, -half.y - bounds.min.y, 0};
}

glm::ivec3 offsetToGround(const IBox& bounds) {
    return bounds.empty() ? glm::ivec3(0) : glm::ivec3(0, 0, -bounds.min.z);
}

}  // namespace voxprite
