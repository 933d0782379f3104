#include "core/edit/selection.h"

#include <utility>

#include "core/edit/cube_bits.h"

namespace voxprite {

namespace {

IBox boxOf(const VoxelBlock& block) {
    return {block.origin, block.origin + block.edgeVoxels};
}

}  // namespace

VoxelSet combined(VoxelSet selection, const VoxelSet& with, SelectMode mode) {
    switch (mode) {
        case SelectMode::replace:
            return with;
        case SelectMode::add:
            selection.unite(with);
            break;
        case SelectMode::remove:
            selection.subtract(with);
            break;
        case SelectMode::intersect:
            selection.intersect(with);
            break;
    }
    return selection;
}

VoxelSet selectAll(const VoxelGrid& voxels) {
    return selectBox(voxels, {glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)});
}

VoxelSet selectBox(const VoxelGrid& voxels, const IBox& box) {
    VoxelSet set;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        const IBox inside = boxOf(block).intersected(box);
        if (inside.empty()) return;
        if (block.voxels == nullptr) {
            set.insert(inside);
        } else {
            insertBits(set, block.origin,
                       solidBits(voxels, block.origin) & boxBits(box, block.origin));
        }
    });
    return set;
}

VoxelSet selectIf(const VoxelGrid& voxels, const std::function<bool(glm::ivec3 v)>& choose) {
    VoxelSet set;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t) {
        if (choose(v)) set.insert(v);
    });
    return set;
}

VoxelSet inverted(const VoxelGrid& voxels, const VoxelSet& selection) {
    VoxelSet set = selectAll(voxels);
    set.subtract(selection);
    return set;
}

VoxelSet stillSolid(const VoxelGrid& voxels, VoxelSet selection) {
    selection.intersect(selectAll(voxels));
    return selection;
}

}  // namespace voxprite
