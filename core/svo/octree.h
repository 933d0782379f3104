// The sparse voxel octree that the game's runtime reads: node words and brick payloads.
// Bit layout after the public description of GpuSvoModel (BenMcLean/Voxel2Pixel).
//
// Space   tree space: the root is a cube of edge 2^maxDepth at the origin, Z up, integer voxels.
//         Cells outside the model's size are empty. Leaves are bricks of 2x2x2 voxels, so the
//         deepest node sits at depth maxDepth - 1; a 1x1x1 model has maxDepth 1.
// Octant  o = (z << 2) | (y << 1) | x, the bits of the coordinate at the node's level.
//
//   node word (32 bits)      31  30  29 ............ 8  7 .......... 0
//     empty                   0   0  0                  0
//     uniform leaf            0   0  0                  material 1..255
//     brick leaf              0   1  payload index (30 bits) ..........
//     internal                1   childBase (bits 30..8)  childMask
//
//   Children that exist stand one after another in octant order from childBase; child o is at
//   childBase + popcount(childMask & ((1 << o) - 1)). Node 0 is the root.
//   payload (64 bits): eight materials, material[o] << (8 * o).
//
// Canonical form: collapsed bottom-up (eight equal materials make a uniform leaf; an internal node
// whose eight children are uniform leaves of one material becomes one), nodes laid out breadth
// first (level by level, within a level in the order of the parents, siblings in octant order),
// payloads in the order of the nodes that own them, none shared. One voxel model has exactly one
// canonical octree.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/box.h"
#include "core/base/result.h"

namespace voxprite {

inline constexpr std::uint32_t kMaxOctreeNodes = 1u << 23;  // childBase has 23 bits
inline constexpr int kMaxOctreeDepth = 16;                  // coordinates 0..65535

namespace node {
inline constexpr std::uint32_t kInternal = 0x8000'0000u;
inline constexpr std::uint32_t kBrick = 0x4000'0000u;

[[nodiscard]] constexpr bool isInternal(std::uint32_t word) {
    return (word & kInternal) != 0;
}
[[nodiscard]] constexpr bool isBrick(std::uint32_t word) {
    return (word & (kInternal | kBrick)) == kBrick;
}
[[nodiscard]] constexpr bool isEmpty(std::uint32_t word) {
    return word == 0;
}
[[nodiscard]] constexpr bool isUniform(std::uint32_t word) {
    return word != 0 && (word & (kInternal | kBrick)) == 0;
}
[[nodiscard]] constexpr std::uint32_t uniform(std::uint8_t material) {
    return material;
}
[[nodiscard]] constexpr std::uint32_t brick(std::uint32_t payload) {
    return kBrick | payload;
}
[[nodiscard]] constexpr std::uint32_t internal(std::uint32_t childBase, std::uint32_t childMask) {
    return kInternal | (childBase << 8) | childMask;
}
[[nodiscard]] constexpr std::uint32_t payloadIndex(std::uint32_t word) {
    return word & 0x3FFF'FFFFu;
}
[[nodiscard]] constexpr std::uint32_t childMask(std::uint32_t word) {
    return word & 0xFFu;
}
[[nodiscard]] constexpr std::uint32_t childBase(std::uint32_t word) {
    return (word & 0x7FFF'FF00u) >> 8;
}
[[nodiscard]] constexpr bool hasChild(std::uint32_t word, unsigned octant) {
    return ((word >> octant) & 1u) != 0;
}
[[nodiscard]] constexpr std::uint32_t childIndex(std::uint32_t word, unsigned octant) {
    return childBase(word) +
           static_cast<std::uint32_t>(std::popcount(childMask(word) & ((1u << octant) - 1u)));
}
}  // namespace node

[[nodiscard]] constexpr std::uint8_t payloadMaterial(std::uint64_t payload, unsigned octant) {
    return static_cast<std::uint8_t>(payload >> (8 * octant));
}

// The octant of a tree coordinate by its bit `bit`: maxDepth - 1 chooses the root's child, 0 the
// voxel of a brick.
[[nodiscard]] constexpr unsigned octantOf(glm::ivec3 tree, int bit) {
    return ((static_cast<unsigned>(tree.z) >> bit & 1u) << 2) |
           ((static_cast<unsigned>(tree.y) >> bit & 1u) << 1) |
           (static_cast<unsigned>(tree.x) >> bit & 1u);
}
// The inverse for one level: (0 or 1) on each axis.
[[nodiscard]] constexpr glm::ivec3 octantCorner(unsigned octant) {
    return {static_cast<int>(octant & 1u), static_cast<int>(octant >> 1 & 1u),
            static_cast<int>(octant >> 2 & 1u)};
}

// What casters and uploads read: somebody else's arrays, valid as long as those are.
struct OctreeView {
    std::span<const std::uint32_t> nodes;
    std::span<const std::uint64_t> payloads;
    int maxDepth = 1;
    // The model's size in voxels; voxel coordinates run over [0, size) from its minimum corner.
    glm::ivec3 size{0};
    // tree coordinate = voxel coordinate + treeFromVoxel. Zero for canonical octrees; the live one
    // keeps its origin while the bounds move. The sum may lie outside the root cube (bounds wider
    // than what the live octree holds): such voxels are empty.
    glm::ivec3 treeFromVoxel{0};
};

// One canonical octree, owned.
struct Octree {
    std::vector<std::uint32_t> nodes{0};
    std::vector<std::uint64_t> payloads;
    int maxDepth = 1;
    glm::ivec3 size{0};    // zero for an empty model, whose only node is the empty root
    glm::ivec3 origin{0};  // entity space of voxel (0,0,0)

    bool operator==(const Octree&) const = default;
    [[nodiscard]] OctreeView view() const { return {nodes, payloads, maxDepth, size, {0, 0, 0}}; }
};

// ceil(log2(max component)), at least 1.
[[nodiscard]] int depthForSize(glm::ivec3 size);

// The material at a voxel coordinate; 0 outside the size. O(depth).
[[nodiscard]] std::uint8_t materialAt(const OctreeView& octree, glm::ivec3 voxel);
// The same by tree coordinate; 0 outside the root cube.
[[nodiscard]] std::uint8_t materialAtTree(const OctreeView& octree, glm::ivec3 tree);

// Solid voxels in the whole tree. O(nodes).
[[nodiscard]] std::uint64_t solidCount(const OctreeView& octree);

}  // namespace voxprite
