#include "core/edit/clip.h"

#include <string>

#include "core/edit/patch_builder.h"
#include "core/edit/selection.h"
#include "core/edit/transforms.h"

namespace voxprite {

namespace {

bool isInRange(const IBox& box) {
    return box.empty() || (isInVoxelRange(box.min) && isInVoxelRange(box.max - 1));
}

}  // namespace

VoxelGrid VoxelClip::placed() const {
    return modelFromClip == Placement{} ? voxels : transformed(voxels, modelFromClip);
}

VoxelSet VoxelClip::footprint() const {
    const VoxelGrid solid = placed();
    VoxelSet set;
    solid.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            set.insert(IBox{block.origin, block.origin + block.edgeVoxels});
        } else {
            set.insertBlock(block.origin, block.voxels);
        }
    });
    return set;
}

VoxelClip copyVoxels(const VoxelGrid& voxels, const VoxelSet& selection) {
    VoxelSet solid = selectAll(voxels);
    solid.intersect(selection);
    VoxelClip clip;
    // The intersection is divided at least as finely as the model is.
    solid.grid().forEachBlock([&](const VoxelBlock& block) {
        const VoxelBlock there = voxels.blockAt(block.origin);
        if (block.voxels == nullptr && there.voxels == nullptr) {
            clip.voxels.fill({block.origin, block.origin + block.edgeVoxels}, there.uniformValue);
            return;
        }
        const CubeBytes members = cubeBytes(solid.grid(), block.origin);
        CubeBytes values = cubeBytes(voxels, block.origin);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (members[i] == 0) values[i] = 0;
        }
        clip.voxels.setBlock(block.origin, values.data());
    });
    return clip;
}

Result<VoxelPatch> patchPaste(const Document& document, int model, const VoxelClip& clip,
                              PasteRule rule, const EditLimits& limits) {
    return patchMove(document, model, VoxelSet(), clip, rule, limits);
}

Result<VoxelPatch> patchMove(const Document& document, int model, const VoxelSet& from,
                             const VoxelClip& clip, PasteRule rule, const EditLimits& limits) {
    if (!isInRange(clip.bounds())) {
        return fail("The voxels would lie beyond +-" + std::to_string(kMaxCoordinate));
    }
    const VoxelGrid laid = clip.placed();
    const Result<std::vector<glm::ivec3>> cubes = cubesOf(from.grid(), laid);
    if (!cubes) return tl::unexpected(cubes.error());
    PatchBuilder builder(document, model, limits);
    for (const glm::ivec3 origin : *cubes) {
        const CubeBytes removed = cubeBytes(from.grid(), origin);
        const CubeBytes added = cubeBytes(laid, origin);
        CubeBytes values = builder.before(origin);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (removed[i] != 0) values[i] = 0;
            if (added[i] != 0 && (rule == PasteRule::over || values[i] == 0)) values[i] = added[i];
        }
        builder.set(origin, values);
    }
    return builder.finish();
}

}  // namespace voxprite
