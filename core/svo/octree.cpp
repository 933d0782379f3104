#include "core/svo/octree.h"

#include <algorithm>

namespace voxprite {

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

}  // namespace voxprite
