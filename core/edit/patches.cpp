#include "core/edit/patches.h"

#include "core/edit/patch_builder.h"
#include "core/edit/voxel_changes.h"

namespace voxprite {

namespace {

std::uint8_t valueAfter(std::uint8_t before, EditMode mode, std::uint8_t value) {
    switch (mode) {
        case EditMode::attach:
            return before == 0 ? value : before;
        case EditMode::erase:
            return 0;
        case EditMode::paint:
            return before == 0 ? before : value;
    }
    return before;
}

void addChange(VoxelPatch& patch, glm::ivec3 position, std::uint8_t before, std::uint8_t after) {
    if (before != after) patch.changes.push_back({position, before, after});
}

template <class Visit>
void forEachPosition(const IBox& box, const Visit& visit) {
    for (int x = box.min.x; x < box.max.x; ++x) {
        for (int y = box.min.y; y < box.max.y; ++y) {
            for (int z = box.min.z; z < box.max.z; ++z) visit(glm::ivec3(x, y, z));
        }
    }
}

}  // namespace

VoxelPatch patchVoxels(const Document& document, int model, std::span<const glm::ivec3> positions,
                       EditMode mode, std::uint8_t value, const EditLimits& limits) {
    VoxelPatch patch{model, {}};
    const VoxelGrid::Reader reader(document.voxelsOf(model));
    for (const glm::ivec3 position : positions) {
        if (!isInVoxelRange(position) || !limits.allow(position)) continue;
        const std::uint8_t before = reader.get(position);
        addChange(patch, position, before, valueAfter(before, mode, value));
    }
    patch.changes = uniqueChanges(std::move(patch.changes));
    return patch;
}

VoxelPatch patchBox(const Document& document, int model, const IBox& requested, EditMode mode,
                    std::uint8_t value) {
    VoxelPatch patch{model, {}};
    const VoxelGrid& voxels = document.voxelsOf(model);
    const IBox box =
        requested.intersected({glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)});
    const VoxelGrid::Reader reader(voxels);
    const auto visit = [&](glm::ivec3 position) {
        const std::uint8_t before = reader.get(position);
        addChange(patch, position, before, valueAfter(before, mode, value));
    };
    if (mode == EditMode::attach) {
        forEachPosition(box, visit);
    } else {
        voxels.forEachBlock([&](const VoxelBlock& block) {
            const IBox cube{block.origin, block.origin + block.edgeVoxels};
            forEachPosition(box.intersected(cube), visit);
        });
    }
    patch.changes = uniqueChanges(std::move(patch.changes));
    return patch;
}

Result<VoxelPatch> patchSet(const Document& document, int model, const VoxelSet& set, EditMode mode,
                            std::uint8_t value, const EditLimits& limits) {
    PatchBuilder builder(document, model, limits);
    // Only what is solid can be erased or painted: go through whichever is smaller.
    const bool throughModel =
        mode != EditMode::attach && builder.voxels().cubeCount() < set.grid().cubeCount();
    const Result<std::vector<glm::ivec3>> cubes =
        cubesOf(throughModel ? builder.voxels() : set.grid());
    if (!cubes) return tl::unexpected(cubes.error());
    for (const glm::ivec3 origin : *cubes) {
        const CubeBytes members = cubeBytes(set.grid(), origin);
        CubeBytes values = builder.before(origin);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (members[i] != 0) values[i] = valueAfter(values[i], mode, value);
        }
        builder.set(origin, values);
    }
    return builder.finish();
}

}  // namespace voxprite
