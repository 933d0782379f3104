#include "core/svo/coarsen.h"

#include <algorithm>
#include <array>

#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

// How often each material occurs in one cell.
class Histogram {
  public:
    void add(std::uint8_t material, std::uint64_t count) {
        if (counts_[material] == 0) seen_[seenCount_++] = material;
        counts_[material] += count;
    }
    [[nodiscard]] bool empty() const { return seenCount_ == 0; }
    // The commonest, of several the lowest.
    [[nodiscard]] std::uint8_t commonest() const {
        std::uint8_t best = seen_[0];
        for (std::size_t i = 1; i < seenCount_; ++i) {
            const std::uint8_t material = seen_[i];
            const bool more = counts_[material] > counts_[best];
            if (more || (counts_[material] == counts_[best] && material < best)) best = material;
        }
        return best;
    }
    void clear() {
        for (std::size_t i = 0; i < seenCount_; ++i) counts_[seen_[i]] = 0;
        seenCount_ = 0;
    }

  private:
    std::array<std::uint64_t, 256> counts_{};
    std::array<std::uint8_t, 256> seen_{};
    std::size_t seenCount_ = 0;
};

// Goes down to the cells with the six neighbours of every node at hand, so that what is exposed is
// known without a look-up. A single voxel is the word of a uniform leaf.
class Coarsener {
  public:
    Coarsener(const OctreeView& source, int levels)
        : source_(source), levels_(levels), builder_(std::max(1, source.maxDepth - levels)) {}

    Result<Octree> run(glm::ivec3 size, glm::ivec3 origin) {
        const Hood root{source_.nodes[0], {}};
        std::uint32_t word = 0;
        if (source_.maxDepth <= levels_) {
            // One cell holds everything: the lowest voxel of a brick.
            if (const std::uint8_t material = materialOf(root, source_.maxDepth)) {
                word = builder_.brick(material);
            }
        } else {
            word = cube(root, 0);
        }
        return builder_.finish(word, size, origin);
    }

  private:
    // Nodes of one size: one of the tree and those across its faces -x, +x, -y, +y, -z, +z.
    struct Hood {
        std::uint32_t word = 0;
        std::array<std::uint32_t, 6> beside{};
    };

    [[nodiscard]] std::uint32_t child(std::uint32_t word, unsigned octant) const {
        if (node::isInternal(word)) {
            return node::hasChild(word, octant) ? source_.nodes[node::childIndex(word, octant)] : 0;
        }
        if (node::isBrick(word)) {
            return payloadMaterial(source_.payloads[node::payloadIndex(word)], octant);
        }
        return word;  // uniform or empty all through
    }

    [[nodiscard]] Hood childHood(const Hood& parent, unsigned octant) const {
        Hood hood{child(parent.word, octant), {}};
        if (hood.word == 0) return hood;  // nobody asks what lies beside nothing
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned bit = 1u << axis;
            const unsigned across = octant ^ bit;
            const std::uint32_t sibling = child(parent.word, across);
            const bool upper = (octant & bit) != 0;
            hood.beside[2 * axis] = upper ? sibling : child(parent.beside[2 * axis], across);
            hood.beside[2 * axis + 1] =
                upper ? child(parent.beside[2 * axis + 1], across) : sibling;
        }
        return hood;
    }

    // The word over a node at `depth` of the source, larger than a cell.
    [[nodiscard]] std::uint32_t cube(const Hood& hood, int depth) {
        if (hood.word == 0) return 0;
        // All of one material: so are its cells.
        if (node::isUniform(hood.word)) return hood.word;
        const int log2Edge = source_.maxDepth - depth;
        if (log2Edge == levels_ + 1) {
            std::uint64_t payload = 0;
            for (unsigned octant = 0; octant < 8; ++octant) {
                const std::uint64_t material = materialOf(childHood(hood, octant), levels_);
                payload |= material << (8 * octant);
            }
            return payload == 0 ? 0 : builder_.brick(payload);
        }
        return builder_.internal(
            depth, [&](unsigned octant) { return cube(childHood(hood, octant), depth + 1); });
    }

    // What the cell shows; 0 when it holds nothing.
    [[nodiscard]] std::uint8_t materialOf(const Hood& cell, int log2Edge) {
        if (cell.word == 0 || node::isUniform(cell.word)) {
            return static_cast<std::uint8_t>(cell.word);
        }
        exposed_.clear();
        all_.clear();
        count(cell, log2Edge);
        if (all_.empty()) return 0;
        return exposed_.empty() ? all_.commonest() : exposed_.commonest();
    }

    void count(const Hood& hood, int log2Edge) {
        if (hood.word == 0) return;
        bool buried = node::isUniform(hood.word);
        for (const std::uint32_t beside : hood.beside) buried = buried && node::isUniform(beside);
        if (buried) {
            all_.add(static_cast<std::uint8_t>(hood.word), std::uint64_t{1} << (3 * log2Edge));
        } else if (log2Edge == 1) {
            countBrick(hood);
        } else {
            for (unsigned octant = 0; octant < 8; ++octant) {
                count(childHood(hood, octant), log2Edge - 1);
            }
        }
    }

    // Two voxels an edge; sets of octants are bits.
    void countBrick(const Hood& hood) {
        constexpr std::array<unsigned, 3> kLower{0x55, 0x33, 0x0F};  // of each axis
        const unsigned solid = solids(hood.word);
        std::array<unsigned, 6> open{};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned lower = kLower[axis];
            const unsigned step = 1u << axis;
            const unsigned before = solids(hood.beside[2 * axis]);
            const unsigned behind = solids(hood.beside[2 * axis + 1]);
            open[2 * axis] = solid & ~((solid & lower) << step | (before >> step & lower));
            open[2 * axis + 1] = solid & ~((solid >> step & lower) | (behind & lower) << step);
        }
        for (unsigned octant = 0; octant < 8; ++octant) {
            if ((solid >> octant & 1u) == 0) continue;
            const auto material = static_cast<std::uint8_t>(child(hood.word, octant));
            unsigned openFaces = 0;
            for (const unsigned face : open) openFaces += face >> octant & 1u;
            all_.add(material, 1);
            if (openFaces > 0) exposed_.add(material, openFaces);
        }
    }

    // The solid octants of a brick.
    [[nodiscard]] unsigned solids(std::uint32_t word) const {
        if (!node::isBrick(word)) return node::isEmpty(word) ? 0u : 0xFFu;
        unsigned solid = 0;
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (child(word, octant) != 0) solid |= 1u << octant;
        }
        return solid;
    }

    const OctreeView& source_;
    int levels_;
    TreeBuilder builder_;
    Histogram exposed_;
    Histogram all_;
};

}  // namespace

Result<Octree> coarsen(const OctreeView& octree, glm::ivec3 origin, int levels) {
    if (levels < 0 || levels > kMaxOctreeDepth) {
        return fail("an octree is made coarser by 0 to " + std::to_string(kMaxOctreeDepth) +
                    " levels, not by " + std::to_string(levels));
    }
    if (octree.size.x <= 0 || octree.size.y <= 0 || octree.size.z <= 0) return Octree{};
    const glm::ivec3 cells = origin >> levels;  // the first one; >> rounds down
    const glm::ivec3 before = origin - (cells << levels);
    // The model from the corner of its first cell on, so that cells are nodes.
    const Result<Octree> aligned =
        relayout(octree, octree.treeFromVoxel - before, octree.size + before, origin - before);
    if (!aligned || levels == 0) return aligned;
    const glm::ivec3 last = (octree.size + before - 1) >> levels;
    return Coarsener(aligned->view(), levels).run(last + 1, cells);
}

Result<Octree> coarsen(const Octree& octree, int levels) {
    return coarsen(octree.view(), octree.origin, levels);
}

}  // namespace voxprite
