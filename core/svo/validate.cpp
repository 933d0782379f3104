#include "core/svo/validate.h"

#include <vector>

#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

Failure failAtNode(std::size_t index, const std::string& what) {
    return failAtByte(index, "octree node " + std::to_string(index) + " " + what);
}

class Validator {
  public:
    explicit Validator(const OctreeView& octree)
        : octree_(octree),
          inside_{octree.treeFromVoxel, octree.treeFromVoxel + octree.size},
          reached_(octree.nodes.size()) {}

    // The recursion is as deep as the octree: 16 at most, since only internal nodes go on and none
    // is allowed at the last level.
    [[nodiscard]] Status check(std::uint32_t index, int depth, glm::ivec3 min) {
        if (reached_[index]) return failAtNode(index, "is reached twice");
        reached_[index] = true;
        const std::uint32_t word = octree_.nodes[index];
        if (node::isEmpty(word)) return {};
        if (node::isBrick(word)) return checkBrick(index, depth, min);
        if (node::isInternal(word)) return checkInternal(index, depth, min);
        if (word > 0xFF) return failAtNode(index, "has stray bits");
        const int edge = 1 << (octree_.maxDepth - depth);
        const IBox cube{min, min + edge};
        if (inside_.intersected(cube) != cube)
            return failAtNode(index, "is solid outside the size");
        return {};
    }

  private:
    [[nodiscard]] Status checkBrick(std::uint32_t index, int depth, glm::ivec3 min) const {
        const std::uint32_t payload = node::payloadIndex(octree_.nodes[index]);
        if (depth != octree_.maxDepth - 1) {
            return failAtNode(index, "is a brick above the last level");
        }
        if (payload >= octree_.payloads.size()) {
            return failAtNode(index, "has a payload beyond the end");
        }
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (payloadMaterial(octree_.payloads[payload], octant) != 0 &&
                !inside_.contains(min + octantCorner(octant))) {
                return failAtNode(index, "is solid outside the size");
            }
        }
        return {};
    }

    [[nodiscard]] Status checkInternal(std::uint32_t index, int depth, glm::ivec3 min) {
        const std::uint32_t word = octree_.nodes[index];
        const std::uint32_t mask = node::childMask(word);
        if (depth == octree_.maxDepth - 1) {
            return failAtNode(index, "has children below the last level");
        }
        if (mask == 0) return failAtNode(index, "has no children");
        const auto end =
            std::uint64_t{node::childBase(word)} + static_cast<std::uint64_t>(std::popcount(mask));
        if (end > octree_.nodes.size()) return failAtNode(index, "has children beyond the end");
        const int half = 1 << (octree_.maxDepth - depth - 1);
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (!node::hasChild(word, octant)) continue;
            const std::uint32_t child = node::childIndex(word, octant);
            if (auto ok = check(child, depth + 1, min + octantCorner(octant) * half); !ok)
                return ok;
        }
        return {};
    }

    const OctreeView& octree_;
    IBox inside_;  // tree space
    std::vector<bool> reached_;
};

[[nodiscard]] bool collapsible(const std::vector<std::uint32_t>& nodes, std::uint32_t word) {
    if (node::childMask(word) != 0xFF) return false;
    const std::uint32_t first = nodes[node::childBase(word)];
    if (!node::isUniform(first)) return false;
    for (std::uint32_t i = 1; i < 8; ++i) {
        if (nodes[node::childBase(word) + i] != first) return false;
    }
    return true;
}

}  // namespace

Status validateOctree(const OctreeView& octree) {
    if (octree.maxDepth < 1 || octree.maxDepth > kMaxOctreeDepth) {
        return fail("the octree's depth is " + std::to_string(octree.maxDepth) +
                    " and not 1 ... 16");
    }
    if (octree.nodes.empty()) return fail("the octree has no root");
    if (octree.nodes.size() > kMaxOctreeNodes)
        return fail("the octree has more than 8,388,608 nodes");
    if (auto ok = checkOctreeSize(octree.size); !ok) return ok;
    return Validator(octree).check(0, 0, glm::ivec3(0));
}

Status validateCanonical(const Octree& octree) {
    if (auto ok = validateOctree(octree.view()); !ok) return ok;
    const bool noSize = octree.size == glm::ivec3(0);
    if (!noSize && IBox{glm::ivec3(0), octree.size}.empty()) {
        return fail("the octree's size is 0 on some axes only");
    }
    if (octree.maxDepth != depthForSize(octree.size)) {
        return fail("the octree's depth " + std::to_string(octree.maxDepth) +
                    " is not that of its size");
    }
    // Breadth first means: reading the words in order, the children of each begin where those of
    // the one before ended, and so do the payloads.
    std::uint64_t nextNode = 1;
    std::uint64_t nextPayload = 0;
    for (std::size_t index = 0; index < octree.nodes.size(); ++index) {
        const std::uint32_t word = octree.nodes[index];
        if (index >= nextNode) return failAtNode(index, "belongs to no parent");
        if (node::isEmpty(word) && index != 0) return failAtNode(index, "is empty but stored");
        if (node::isInternal(word)) {
            if (node::childBase(word) != nextNode) {
                return failAtNode(index, "has children out of breadth-first order");
            }
            if (collapsible(octree.nodes, word)) return failAtNode(index, "is not collapsed");
            nextNode += static_cast<std::uint64_t>(std::popcount(node::childMask(word)));
        } else if (node::isBrick(word)) {
            if (node::payloadIndex(word) != nextPayload) {
                return failAtNode(index, "has a payload out of order");
            }
            const std::uint64_t payload = octree.payloads[nextPayload++];
            if (payload == uniformPayload(payloadMaterial(payload, 0))) {
                return failAtNode(index, "is a brick of one material");
            }
        }
    }
    if (nextPayload != octree.payloads.size()) return fail("the octree has payloads without owner");
    return {};
}

}  // namespace voxprite
