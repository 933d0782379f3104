#include "core/svo/octree.h"

#include <algorithm>

namespace voxprite {
namespace {

std::uint64_t solidsUnder(const OctreeView& octree, std::uint32_t word, int depth) {
    if (node::isUniform(word)) return std::uint64_t{1} << 3 * (octree.maxDepth - depth);
    std::uint64_t solids = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        if (node::isBrick(word)) {
            const std::uint64_t payload = octree.payloads[node::payloadIndex(word)];
            solids += payloadMaterial(payload, octant) != 0 ? 1 : 0;
        } else if (node::hasChild(word, octant)) {
            const std::uint32_t child = octree.nodes[node::childIndex(word, octant)];
            solids += solidsUnder(octree, child, depth + 1);
        }
    }
    return solids;
}

}  // namespace

int depthForSize(glm::ivec3 size) {
    const int longest = std::max({size.x, size.y, size.z, 1});
    return std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(longest) - 1u)));
}

std::uint8_t materialAt(const OctreeView& octree, glm::ivec3 voxel) {
    if (!IBox{glm::ivec3(0), octree.size}.contains(voxel)) return 0;
    return materialAtTree(octree, voxel + octree.treeFromVoxel);
}

std::uint8_t materialAtTree(const OctreeView& octree, glm::ivec3 tree) {
    const int edge = 1 << octree.maxDepth;
    if (!IBox{glm::ivec3(0), glm::ivec3(edge)}.contains(tree)) return 0;
    std::uint32_t word = octree.nodes[0];
    int bit = octree.maxDepth - 1;
    while (node::isInternal(word)) {
        const unsigned octant = octantOf(tree, bit--);
        if (!node::hasChild(word, octant)) return 0;
        word = octree.nodes[node::childIndex(word, octant)];
    }
    if (node::isBrick(word)) {
        return payloadMaterial(octree.payloads[node::payloadIndex(word)], octantOf(tree, 0));
    }
    return static_cast<std::uint8_t>(word);
}

std::uint64_t solidCount(const OctreeView& octree) {
    return solidsUnder(octree, octree.nodes[0], 0);
}

}  // namespace voxprite
