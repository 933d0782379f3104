#include "core/edit/reshape.h"

#include <string>

#include "core/edit/patch_builder.h"
#include "core/edit/regions.h"
#include "core/edit/selection.h"
#include "core/edit/transforms.h"
#include "core/model/voxel_morphology.h"

namespace voxprite {

namespace {

Result<VoxelPatch> patchReshaped(const Document& document, int model,
                                 const Result<VoxelGrid>& after, const EditLimits& limits) {
    if (!after) return tl::unexpected(after.error());
    return patchReplace(document, model, *after, limits);
}

}  // namespace

Result<VoxelPatch> patchReplace(const Document& document, int model, const VoxelGrid& after,
                                const EditLimits& limits) {
    PatchBuilder builder(document, model, limits);
    const Result<std::vector<glm::ivec3>> cubes = cubesOf(builder.voxels(), after);
    if (!cubes) return tl::unexpected(cubes.error());
    for (const glm::ivec3 origin : *cubes) builder.set(origin, cubeBytes(after, origin));
    return builder.finish();
}

Result<VoxelPatch> patchRecolour(const Document& document, int model, std::uint8_t from,
                                 std::uint8_t to, const EditLimits& limits) {
    const VoxelSet recoloured = voxelsOfColour(document.voxelsOf(model), from);
    const EditMode mode = to == 0 ? EditMode::erase : EditMode::paint;
    return patchSet(document, model, recoloured, mode, to, limits);
}

Result<VoxelPatch> patchCrop(const Document& document, int model, const VoxelSet& keep) {
    return patchSet(document, model, inverted(document.voxelsOf(model), keep), EditMode::erase, 0);
}

Result<VoxelPatch> patchHollow(const Document& document, int model, int wall,
                               const EditLimits& limits) {
    return patchReshaped(document, model, hollowed(document.voxelsOf(model), wall), limits);
}

Result<VoxelPatch> patchDilate(const Document& document, int model, int layers,
                               const EditLimits& limits) {
    return patchReshaped(document, model, dilated(document.voxelsOf(model), layers), limits);
}

Result<VoxelPatch> patchErode(const Document& document, int model, int layers,
                              const EditLimits& limits) {
    return patchReshaped(document, model, eroded(document.voxelsOf(model), layers), limits);
}

Result<VoxelPatch> patchSmooth(const Document& document, int model, int passes,
                               const EditLimits& limits) {
    return patchReshaped(document, model, smoothed(document.voxelsOf(model), passes), limits);
}

Result<VoxelPatch> patchTranslate(const Document& document, int model, glm::ivec3 byVoxels) {
    const VoxelGrid& voxels = document.voxelsOf(model);
    const IBox bounds = voxels.bounds();
    const bool tooFar = !isInVoxelRange(byVoxels) ||
                        (!bounds.empty() && (!isInVoxelRange(bounds.min + byVoxels) ||
                                             !isInVoxelRange(bounds.max - 1 + byVoxels)));
    if (tooFar) {
        return fail("The voxels would lie beyond +-" + std::to_string(kMaxCoordinate));
    }
    return patchReplace(document, model, transformed(voxels, translation(byVoxels)));
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
