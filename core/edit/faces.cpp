#include "core/edit/faces.h"

#include <cstdlib>
#include <string>

#include "core/base/check.h"
#include "core/edit/clip.h"

namespace voxprite {

namespace {

// The voxels first ... last steps along `normal` from `v`.
IBox along(glm::ivec3 v, glm::ivec3 normal, int first, int last) {
    return IBox::around(v + normal * first, v + normal * last);
}

IBox withinRange(const IBox& box) {
    return box.intersected({glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)});
}

}  // namespace

Result<VoxelPatch> patchFaces(const Document& document, int model, std::span<const MovedFace> faces,
                              int layers, std::optional<std::uint8_t> colour,
                              const EditLimits& limits) {
    VOXPRITE_CHECK(model >= 0 && static_cast<std::size_t>(model) < document.models.size());
    if (std::abs(layers) > kMaxFaceLayers) {
        return fail("A face moves by at most " + std::to_string(kMaxFaceLayers) + " layers, not " +
                    std::to_string(layers));
    }
    std::uint64_t count = 0;
    for (const MovedFace& moved : faces) count += moved.face.count();
    count *= static_cast<std::uint64_t>(std::abs(layers));
    if (count > kMaxPatchVoxels) {
        return fail("The edit is too large: these layers have " + std::to_string(count) +
                    " voxels; at most " + std::to_string(kMaxPatchVoxels) + " change at once");
    }
    if (layers < 0) {
        VoxelSet removed;
        for (const MovedFace& moved : faces) {
            moved.face.forEach(
                [&](glm::ivec3 v) { removed.insert(along(v, -moved.normal, 0, -layers - 1)); });
        }
        return patchSet(document, model, removed, EditMode::erase, 0, limits);
    }
    VoxelClip pulled;
    if (layers > 0) {
        const VoxelGrid::Reader reader(document.models[static_cast<std::size_t>(model)].voxels);
        for (const MovedFace& moved : faces) {
            moved.face.forEach([&](glm::ivec3 v) {
                pulled.voxels.fill(withinRange(along(v, moved.normal, 1, layers)),
                                   colour.value_or(reader.get(v)));
            });
        }
    }
    return patchPaste(document, model, pulled, PasteRule::under, limits);
}

}  // namespace voxprite
