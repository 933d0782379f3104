// Puts a canonical octree together from words handed over depth first, in octant order.
//
// Walked that way, each level's nodes come in exactly their breadth-first order, so every level is
// a flat array that only grows at its end; collapsing a node takes its eight children off that end.
// finish() joins the levels. No node is allocated one by one, none is moved twice.
//
// Subtrees may be put together by several builders at once, each with its own levels: joined in the
// order of the subtrees they are the levels of the whole.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/raw_vector.h"
#include "core/svo/octree.h"

namespace voxprite {

[[nodiscard]] constexpr std::uint64_t uniformPayload(std::uint8_t material) {
    return material * 0x0101'0101'0101'0101ull;
}

// Fails when an edge is longer than an octree can address.
[[nodiscard]] Status checkOctreeSize(glm::ivec3 size);

class TreeBuilder {
  public:
    explicit TreeBuilder(int maxDepth) : maxDepth_(maxDepth) {}

    [[nodiscard]] int maxDepth() const { return maxDepth_; }

    // The word of a 2x2x2 brick.
    [[nodiscard]] std::uint32_t brick(std::uint64_t payload) {
        const auto first = static_cast<std::uint8_t>(payload);
        if (payload == uniformPayload(first)) return node::uniform(first);
        payloads_.push_back(payload);
        return node::brick(static_cast<std::uint32_t>(payloads_.size() - 1));
    }

    // The word of an internal node at `depth`; child(octant) gives its children's words in turn.
    template <class Child>
    [[nodiscard]] std::uint32_t internal(int depth, const Child& child) {
        Words& level = levels_[static_cast<std::size_t>(depth) + 1];
        const std::size_t base = level.size();
        std::uint32_t mask = 0;
        for (unsigned octant = 0; octant < 8; ++octant) {
            const std::uint32_t word = child(octant);
            if (node::isEmpty(word)) continue;
            level.push_back(word);
            mask |= 1u << octant;
        }
        if (mask == 0) return 0;
        if (mask == 0xFF && node::isUniform(level[base]) && allEqual(level, base)) {
            const std::uint32_t word = level[base];
            level.resize(base);
            return word;
        }
        nodeCount_ += level.size() - base;
        return node::internal(static_cast<std::uint32_t>(base), mask);
    }

    // The word of a cube of eight voxels an edge (or of the whole tree, if that is smaller, from
    // the first of them) that is not uniform, from the payloads of its bricks in the order of
    // octants.
    [[nodiscard]] std::uint32_t cube(const std::array<std::uint64_t, 64>& payloads);

    // Room for the nodes of so many cubes of eight, as models usually have them.
    void reserve(std::size_t cubes);

    // More nodes than an octree can hold: whatever is still to come, finish() will fail.
    [[nodiscard]] bool full() const { return nodeCount_ > kMaxOctreeNodes; }

    [[nodiscard]] std::uint64_t nodeCount() const { return nodeCount_; }
    [[nodiscard]] std::size_t nodesAt(int depth) const {
        return levels_[static_cast<std::size_t>(depth)].size();
    }

    // `parts` hold what lies below this one's nodes, where this one has none: a word that was made
    // by one of them has the number of nodes before it (those that the parts before it have at the
    // depth of its children) added to its child base. Fails beyond kMaxOctreeNodes.
    [[nodiscard]] Result<Octree> finish(std::uint32_t root, glm::ivec3 size, glm::ivec3 origin,
                                        std::span<const TreeBuilder> parts = {},
                                        int threads = 1) const;

  private:
    using Words = RawVector<std::uint32_t>;

    [[nodiscard]] static bool allEqual(const Words& level, std::size_t base) {
        for (std::size_t i = base + 1; i < base + 8; ++i) {
            if (level[i] != level[base]) return false;
        }
        return true;
    }

    int maxDepth_;
    // levels_[d] holds the nodes at depth d (d >= 1), child bases counted from the start of d + 1.
    std::array<Words, kMaxOctreeDepth + 1> levels_;
    RawVector<std::uint64_t> payloads_;
    std::uint64_t nodeCount_ = 1;  // the root; only nodes that have come to stay
};

// The voxels [shift, shift + size) of `source`, in its tree space, as a canonical octree that
// starts at the corner `shift`. The arrays of the source need not be canonical.
[[nodiscard]] Result<Octree> relayout(const OctreeView& source, glm::ivec3 shift, glm::ivec3 size,
                                      glm::ivec3 origin);

}  // namespace voxprite
