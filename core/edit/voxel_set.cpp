#include "core/edit/voxel_set.h"

#include <algorithm>
#include <array>

namespace voxprite {

namespace {

constexpr int kEdge = 8;
constexpr std::size_t kBlockVoxels = 512;

// The bytes of a cube of 8 of whatever block holds it, each `choose`(own, other).
template <class Choose>
std::array<std::uint8_t, kBlockVoxels> combinedBytes(const VoxelBlock& own, const VoxelBlock& other,
                                                     const Choose& choose) {
    std::array<std::uint8_t, kBlockVoxels> bytes;
    const auto at = [](const VoxelBlock& block, std::size_t i) {
        return (block.voxels == nullptr ? block.uniformValue : block.voxels[i]) != 0;
    };
    for (std::size_t i = 0; i < kBlockVoxels; ++i) bytes[i] = choose(at(own, i), at(other, i));
    return bytes;
}

}  // namespace

VoxelSet::VoxelSet(std::span<const glm::ivec3> positions) {
    for (const glm::ivec3 v : positions) insert(v);
}

void VoxelSet::forEach(const std::function<void(glm::ivec3 v)>& visit) const {
    members_.forEachSolid([&](glm::ivec3 v, std::uint8_t) { visit(v); });
}

void VoxelSet::insert(glm::ivec3 v) {
    if (isInVoxelRange(v)) members_.set(v, 1);
}

void VoxelSet::insert(const IBox& box) {
    members_.fill(box.intersected(voxelRange()), 1);
}

void VoxelSet::erase(glm::ivec3 v) {
    if (isInVoxelRange(v)) members_.set(v, 0);
}

void VoxelSet::insertBlock(glm::ivec3 origin, const std::uint8_t* voxels) {
    const VoxelBlock given{origin, kEdge, 0, voxels};
    const IBox box = given.box();
    if (box.intersected(voxelRange()) == box) {
        members_.setBlock(origin,
                          combinedBytes(members_.blockAt(origin), given, [](bool a, bool b) {
                              return a || b;
                          }).data());
        return;
    }
    for (int i = 0; i < static_cast<int>(kBlockVoxels); ++i) {
        if (voxels[i] != 0) insert(origin + glm::ivec3(i >> 6, (i >> 3) & 7, i & 7));
    }
}

void VoxelSet::unite(const VoxelSet& other) {
    if (&other == this) return;
    other.members_.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            insert(block.box());
        } else {
            insertBlock(block.origin, block.voxels);
        }
    });
}

void VoxelSet::subtract(const VoxelSet& other) {
    if (&other == this) {
        members_.clear();
        return;
    }
    other.members_.forEachBlock([&](const VoxelBlock& block) {
        const VoxelBlock own = members_.blockAt(block.origin);
        const bool nothingThere =
            own.voxels == nullptr && own.uniformValue == 0 && own.edgeVoxels >= block.edgeVoxels;
        if (nothingThere) return;
        if (block.edgeVoxels > kEdge) {
            members_.fill(block.box().intersected(voxelRange()), 0);
        } else {
            members_.setBlock(block.origin, combinedBytes(own, block, [](bool a, bool b) {
                                                return a && !b;
                                            }).data());
        }
    });
}

void VoxelSet::intersect(const VoxelSet& other) {
    if (&other == this) return;
    // Each place where both are stored is visited from the side that is divided finer.
    VoxelSet common;
    const auto visit = [&](const VoxelGrid& grid, bool alsoEqual) {
        return [&common, &grid, alsoEqual](const VoxelBlock& block) {
            const VoxelBlock there = grid.blockAt(block.origin);
            const bool coarser = there.edgeVoxels > block.edgeVoxels;
            if (!coarser && !(alsoEqual && there.edgeVoxels == block.edgeVoxels)) return;
            if (block.voxels == nullptr && there.voxels == nullptr) {
                if (there.uniformValue != 0) common.insert(block.box());
                return;
            }
            common.insertBlock(block.origin, combinedBytes(block, there, [](bool a, bool b) {
                                                 return a && b;
                                             }).data());
        };
    };
    members_.forEachBlock(visit(other.members_, true));
    other.members_.forEachBlock(visit(members_, false));
    *this = std::move(common);
}

}  // namespace voxprite
