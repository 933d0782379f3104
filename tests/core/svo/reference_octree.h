// A second opinion on octrees: a decoder and a baker written from the format's description alone,
// slow and plain, sharing no code with core/svo.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite::test {

inline std::uint8_t decodeVoxel(const std::vector<std::uint32_t>& nodes,
                                const std::vector<std::uint64_t>& payloads, int maxDepth,
                                unsigned x, unsigned y, unsigned z) {
    std::uint32_t word = nodes.at(0);
    for (int level = maxDepth - 1;; --level) {
        const bool internal = (word >> 31) != 0;
        if (!internal && ((word >> 30) & 1) == 0) return static_cast<std::uint8_t>(word & 0xFF);
        const unsigned octant =
            (((z >> level) & 1) << 2) | (((y >> level) & 1) << 1) | ((x >> level) & 1);
        if (!internal) {
            const std::uint64_t payload = payloads.at(word & 0x3FFFFFFF);
            return static_cast<std::uint8_t>((payload >> (8 * octant)) & 0xFF);
        }
        if (((word >> octant) & 1) == 0) return 0;
        std::uint32_t child = (word >> 8) & 0x7FFFFF;
        for (unsigned lower = 0; lower < octant; ++lower) child += (word >> lower) & 1;
        word = nodes.at(child);
    }
}

// A pointer tree, collapsed bottom-up, written out with a queue.
class ReferenceBaker {
  public:
    ReferenceBaker(const VoxelGrid& voxels, const IBox& bounds)
        : voxels_(voxels), bounds_(bounds) {}

    Octree bake() {
        Octree octree;
        octree.size = bounds_.size();
        octree.origin = bounds_.min;
        int edge = 2;
        octree.maxDepth = 1;
        while (edge < octree.size.x || edge < octree.size.y || edge < octree.size.z) {
            edge *= 2;
            ++octree.maxDepth;
        }
        const std::unique_ptr<Tree> root = build(glm::ivec3(0), edge);
        octree.nodes.clear();
        std::uint32_t end = 1;
        std::deque<const Tree*> queue{root.get()};
        for (; !queue.empty(); queue.pop_front()) {
            const Tree& tree = *queue.front();
            if (tree.uniform) {
                octree.nodes.push_back(tree.value);
            } else if (tree.children.empty()) {
                octree.nodes.push_back(0x40000000u |
                                       static_cast<std::uint32_t>(octree.payloads.size()));
                octree.payloads.push_back(tree.payload);
            } else {
                std::uint32_t mask = 0;
                const std::uint32_t base = end;
                for (unsigned octant = 0; octant < 8; ++octant) {
                    const Tree* child = tree.children[octant].get();
                    if (child->uniform && child->value == 0) continue;
                    mask |= 1u << octant;
                    queue.push_back(child);
                    ++end;
                }
                octree.nodes.push_back(0x80000000u | base << 8 | mask);
            }
        }
        return octree;
    }

  private:
    struct Tree {
        bool uniform = false;
        std::uint8_t value = 0;  // of a uniform one; 0 is empty
        std::uint64_t payload = 0;
        std::vector<std::unique_ptr<Tree>> children;  // eight, or none
    };

    std::unique_ptr<Tree> build(glm::ivec3 min, int edge) {
        auto tree = std::make_unique<Tree>();
        if (edge == 2) {
            bool equal = true;
            for (int octant = 7; octant >= 0; --octant) {
                const glm::ivec3 v = min + glm::ivec3(octant & 1, octant >> 1 & 1, octant >> 2);
                const IBox inside{glm::ivec3(0), bounds_.size()};
                const std::uint8_t value =
                    inside.contains(v) ? voxels_.get(v + bounds_.min) : std::uint8_t{0};
                tree->payload = tree->payload << 8 | value;
                if (octant == 7) tree->value = value;
                equal = equal && value == tree->value;
            }
            tree->uniform = equal;
            return tree;
        }
        bool equal = true;
        for (int octant = 0; octant < 8; ++octant) {
            const glm::ivec3 bits(octant & 1, octant >> 1 & 1, octant >> 2);
            tree->children.push_back(build(min + bits * (edge / 2), edge / 2));
            const Tree& child = *tree->children.back();
            equal = equal && child.uniform && child.value == tree->children[0]->value;
        }
        if (equal) {
            tree->uniform = true;
            tree->value = tree->children[0]->value;
            tree->children.clear();
        }
        return tree;
    }

    const VoxelGrid& voxels_;
    IBox bounds_;
};

inline glm::ivec3 randomIn(std::mt19937& random, glm::ivec3 min, glm::ivec3 max) {
    const auto one = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high - 1)(random);
    };
    const int x = one(min.x, max.x);
    const int y = one(min.y, max.y);
    return {x, y, one(min.z, max.z)};
}

// Boxes and single voxels of few materials, some erased again, somewhere around `centre`.
inline VoxelGrid randomModel(std::mt19937& random, glm::ivec3 centre, int extent) {
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    VoxelGrid voxels;
    const glm::ivec3 low = centre - extent / 2;
    const glm::ivec3 high = low + extent;
    const int materials = 1 + below(4);
    for (int i = below(6); i > 0; --i) {
        const IBox box = IBox::around(randomIn(random, low, high), randomIn(random, low, high));
        voxels.fill(box, static_cast<std::uint8_t>(below(4) == 0 ? 0 : 1 + below(materials)));
    }
    for (int i = 1 + below(extent * extent); i > 0; --i) {
        const int value = below(5) == 0 ? 0 : below(2) == 0 ? 255 : 1 + below(materials);
        voxels.set(randomIn(random, low, high), static_cast<std::uint8_t>(value));
    }
    return voxels;
}

}  // namespace voxprite::test
