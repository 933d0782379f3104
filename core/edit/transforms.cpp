#include "core/edit/transforms.h"

#include <string>

namespace voxprite {

namespace {

// One step of one axis, as `rotation` turns it.
struct Steps {
    glm::ivec3 x, y, z;
    explicit Steps(const SignedPermutation& rotation)
        : x(rotation.apply({1, 0, 0})),
          y(rotation.apply({0, 1, 0})),
          z(rotation.apply({0, 0, 1})) {}
};

// visit(corner within the block, value) for the solid voxels of a leaf.
template <class Visit>
void forEachOfLeaf(const VoxelBlock& leaf, const Visit& visit) {
    for (int i = 0; i < leaf.edgeVoxels * leaf.edgeVoxels * leaf.edgeVoxels; ++i) {
        if (leaf.voxels[i] != 0) visit(glm::ivec3(i >> 6, (i >> 3) & 7, i & 7), leaf.voxels[i]);
    }
}

}  // namespace

Placement translation(glm::ivec3 byVoxels) {
    return {SignedPermutation{}, byVoxels};
}

SignedPermutation quarterTurns(int axis, int turns) {
    // About z: x' = -y, y' = x; and so on around.
    const auto a = static_cast<std::size_t>((axis + 1) % 3);
    const auto b = static_cast<std::size_t>((axis + 2) % 3);
    SignedPermutation once;
    once.axis[a] = static_cast<std::uint8_t>(b);
    once.axis[b] = static_cast<std::uint8_t>(a);
    once.sign[a] = -1;
    SignedPermutation all;
    for (int i = 0; i < (turns % 4 + 4) % 4; ++i) all = once * all;
    return all;
}

SignedPermutation flip(int axis) {
    SignedPermutation mirror;
    mirror.sign[static_cast<std::size_t>(axis)] = -1;
    return mirror;
}

Placement inPlace(const SignedPermutation& rotation, const IBox& box) {
    Placement placement{rotation, glm::ivec3(0)};
    const IBox turned = placement.applyToBox(box);
    // The division rounds toward zero, so that a turn moves the corner by as much as the next one
    // moves it back.
    placement.translation = box.min - turned.min + (box.size() - turned.size()) / 2;
    return placement;
}

void turn(VoxelClip& clip, int axis, int turns) {
    // One by one, so that two turns are what one and then one more is.
    for (int i = 0; i < (turns % 4 + 4) % 4; ++i) {
        clip.modelFromClip = inPlace(quarterTurns(axis, 1), clip.bounds()) * clip.modelFromClip;
    }
}

void flip(VoxelClip& clip, int axis) {
    clip.modelFromClip = inPlace(flip(axis), clip.bounds()) * clip.modelFromClip;
}

void moveBy(VoxelClip& clip, glm::ivec3 byVoxels) {
    clip.modelFromClip.translation += byVoxels;
}

Status scale(VoxelClip& clip, int factor) {
    if (factor < 1) return fail("A scale of " + std::to_string(factor) + " is below 1");
    const VoxelGrid placed = clip.placed();
    const IBox box = placed.bounds();
    const auto cubed = static_cast<double>(factor) * factor * factor;
    if (static_cast<double>(placed.solidCount()) * cubed > static_cast<double>(kMaxPatchVoxels)) {
        return fail("Scaled by " + std::to_string(factor) + " it would be more than " +
                    std::to_string(kMaxPatchVoxels) + " voxels");
    }
    for (int axis = 0; axis < 3 && !box.empty(); ++axis) {
        const std::int64_t end = box.min[axis] + std::int64_t{box.size()[axis]} * factor;
        if (end - 1 > kMaxCoordinate) {
            return fail("Scaled by " + std::to_string(factor) + " it would reach beyond +-" +
                        std::to_string(kMaxCoordinate) + " voxels");
        }
    }
    VoxelClip scaled;
    placed.forEachBlock([&](const VoxelBlock& block) {
        const auto fillCell = [&](const IBox& cell, std::uint8_t value) {
            scaled.voxels.fill(
                {box.min + (cell.min - box.min) * factor, box.min + (cell.max - box.min) * factor},
                value);
        };
        if (block.voxels == nullptr) {
            fillCell(block.box(), block.uniformValue);
        } else {
            forEachOfLeaf(block, [&](glm::ivec3 corner, std::uint8_t value) {
                fillCell({block.origin + corner, block.origin + corner + 1}, value);
            });
        }
    });
    clip = std::move(scaled);
    return {};
}

VoxelGrid transformed(const VoxelGrid& voxels, const Placement& placement) {
    VoxelGrid result;
    const Steps step(placement.rotation);
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            result.fill(placement.applyToBox(block.box()).intersected(voxelRange()),
                        block.uniformValue);
            return;
        }
        const glm::ivec3 first = placement.applyToVoxel(block.origin);
        forEachOfLeaf(block, [&](glm::ivec3 v, std::uint8_t value) {
            const glm::ivec3 to = first + step.x * v.x + step.y * v.y + step.z * v.z;
            if (isInVoxelRange(to)) result.set(to, value);
        });
    });
    return result;
}

VoxelSet transformed(const VoxelSet& set, const Placement& placement) {
    VoxelSet result;
    const Steps step(placement.rotation);
    set.grid().forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            result.insert(placement.applyToBox(block.box()));
            return;
        }
        const glm::ivec3 first = placement.applyToVoxel(block.origin);
        forEachOfLeaf(block, [&](glm::ivec3 v, std::uint8_t) {
            result.insert(first + step.x * v.x + step.y * v.y + step.z * v.z);
        });
    });
    return result;
}

}  // namespace voxprite
