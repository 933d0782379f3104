// Puts a canonical octree together from words handed over depth first, in octant order.
//
// Walked that way, each level's nodes come in exactly their breadth-first order, so every level is
// a flat array that only grows at its end; collapsing a node takes its eight children off that end.
// finish() joins the levels. No node is allocated one by one, none is moved twice.
//
// Subtrees may be put together by several builders at once, each with its own levels: joined in the
// order of the subtrees they are the levels of the whole.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/svo/growing_array.h"
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
        std::array<std::uint32_t, 8> words;
        for (unsigned octant = 0; octant < 8; ++octant) words[octant] = child(octant);
        return internal(depth, words);
    }
    [[nodiscard]] std::uint32_t internal(int depth, const std::array<std::uint32_t, 8>& children);

    // The word of a cube of eight voxels an edge (or of the whole tree, if that is smaller, from
    // the first of its bricks) out of 64 bricks in the order of octants. Bit i of `solid`: brick i
    // is not empty; of `full`: it has eight voxels. payloadOf(i) is asked of those that are solid,
    // in that order.
    template <class PayloadOf>
    [[nodiscard]] std::uint32_t cube(std::uint64_t solid, std::uint64_t full,
                                     const PayloadOf& payloadOf);

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
    using Words = GrowingArray<std::uint32_t>;

    // 1 or 0. Said so that no compiler makes a branch of it, which random bricks would mislead.
    [[nodiscard]] static std::uint32_t isNotZero(std::uint64_t x) {
        return static_cast<std::uint32_t>((x | (0 - x)) >> 63);
    }

    int maxDepth_;
    // levels_[d] holds the nodes at depth d (d >= 1), child bases counted from the start of d + 1.
    std::array<Words, kMaxOctreeDepth + 1> levels_;
    GrowingArray<std::uint64_t> payloads_;
    std::uint64_t nodeCount_ = 1;  // the root; only nodes that have come to stay
};

template <class PayloadOf>
std::uint32_t TreeBuilder::cube(std::uint64_t solid, std::uint64_t full,
                                const PayloadOf& payloadOf) {
    const auto brickOf = [&](unsigned i) {
        return (solid >> i & 1u) != 0 ? brick(payloadOf(i)) : std::uint32_t{0};
    };
    if (maxDepth_ == 1) return brickOf(0);
    if (maxDepth_ == 2) return internal(0, brickOf);

    Words& fourLevel = levels_[static_cast<std::size_t>(maxDepth_) - 2];  // cubes of four
    Words& brickLevel = levels_[static_cast<std::size_t>(maxDepth_) - 1];
    std::uint32_t* const fours = fourLevel.room(8);
    std::uint32_t* const bricks = brickLevel.room(64 + 8);  // the last are written eight at once
    std::uint64_t* const payloads = payloads_.room(64 + 1);
    const auto firstBrick = static_cast<std::uint32_t>(brickLevel.size());
    const std::uint32_t firstWord = node::brick(static_cast<std::uint32_t>(payloads_.size()));
    std::uint32_t* four = fours;
    std::uint32_t* brick = bricks;
    std::uint64_t* payload = payloads;
    std::uint32_t foursMask = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const auto mask = static_cast<std::uint32_t>(solid >> (8 * octant) & 0xFFu);
        if (mask == 0) continue;
        foursMask |= 1u << octant;
        std::uint32_t* const base = brick;
        const std::uint32_t word =
            node::internal(firstBrick + static_cast<std::uint32_t>(base - bricks), mask);
        std::uint32_t nextWord = firstWord + static_cast<std::uint32_t>(payload - payloads);
        if ((full >> (8 * octant) & 0xFFu) == 0) {  // no brick of one material
            for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
                *payload++ = payloadOf(8 * octant + static_cast<unsigned>(std::countr_zero(rest)));
            }
            for (unsigned i = 0; i < 8; ++i) base[i] = nextWord + i;
            brick += std::popcount(mask);
            *four++ = word;
            continue;
        }
        std::uint32_t unlike = 0;
        for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
            *payload = payloadOf(8 * octant + static_cast<unsigned>(std::countr_zero(rest)));
            const std::uint32_t mixed = isNotZero(*payload ^ std::rotl(*payload, 8));
            const auto uniform = static_cast<std::uint32_t>(*payload & 0xFFu);
            *brick = uniform ^ ((uniform ^ nextWord) & (0 - mixed));
            payload += mixed;
            nextWord += mixed;
            unlike |= *brick++ ^ *base;
        }
        const bool collapses = mask == 0xFF && unlike == 0;  // words of mixed bricks all differ
        *four++ = collapses ? *base : word;
        if (collapses) brick = base;
    }
    if (foursMask == 0xFF && brick == bricks && std::count(fours, fours + 8, *fours) == 8) {
        return *fours;
    }
    fourLevel.add(static_cast<std::size_t>(four - fours));
    brickLevel.add(static_cast<std::size_t>(brick - bricks));
    payloads_.add(static_cast<std::size_t>(payload - payloads));
    nodeCount_ += static_cast<std::uint64_t>((four - fours) + (brick - bricks));
    return node::internal(
        static_cast<std::uint32_t>(fourLevel.size()) - static_cast<std::uint32_t>(four - fours),
        foursMask);
}

// The voxels [shift, shift + size) of `source`, in its tree space, as a canonical octree that
// starts at the corner `shift`. The arrays of the source need not be canonical.
[[nodiscard]] Result<Octree> relayout(const OctreeView& source, glm::ivec3 shift, glm::ivec3 size,
                                      glm::ivec3 origin);

}  // namespace voxprite
