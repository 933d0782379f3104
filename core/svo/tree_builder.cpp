#include "core/svo/tree_builder.h"

#include <cstring>

#include "core/base/parallel.h"

namespace voxprite {

Status checkOctreeSize(glm::ivec3 size) {
    constexpr int kMaxEdge = 1 << kMaxOctreeDepth;
    for (int axis = 0; axis < 3; ++axis) {
        // Negative: the difference of two bounds did not fit an int.
        if (size[axis] > kMaxEdge || size[axis] < 0) {
            return fail("the model is too long for an octree along " + std::string(1, "xyz"[axis]) +
                        ": more than 65,536 voxels");
        }
    }
    return {};
}

void TreeBuilder::reserve(std::size_t cubes) {
    if (maxDepth_ < 3) return;
    // What is not needed is never touched; what is copied to a larger array is.
    static_cast<void>(levels_[static_cast<std::size_t>(maxDepth_) - 2].room(8 * cubes));
    static_cast<void>(levels_[static_cast<std::size_t>(maxDepth_) - 1].room(24 * cubes + 72));
    static_cast<void>(payloads_.room(16 * cubes + 72));
}

std::uint32_t TreeBuilder::internal(int depth, const std::array<std::uint32_t, 8>& children) {
    Words& level = levels_[static_cast<std::size_t>(depth) + 1];
    std::uint32_t* const room = level.room(8);
    std::uint32_t mask = 0, count = 0, unlike = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const std::uint32_t word = children[octant];
        const std::uint32_t solid = isNotZero(word);
        room[count] = word;
        count += solid;
        mask |= solid << octant;
        unlike |= word ^ children[0];
    }
    if (unlike == 0 && (node::isUniform(children[0]) || mask == 0)) return children[0];
    const auto base = static_cast<std::uint32_t>(level.size());
    level.add(count);
    nodeCount_ += count;
    return node::internal(base, mask);
}

namespace {

// Words of this kind grow by `added`, the others are copied as they are.
void copyAdding(std::span<const std::uint32_t> words, std::uint32_t kind, std::uint32_t added,
                std::uint32_t* to) {
    using Four = std::uint32_t __attribute__((vector_size(16)));
    std::size_t i = 0;
    for (; i + 4 <= words.size(); i += 4) {
        Four four;
        std::memcpy(&four, &words[i], sizeof four);
        four += reinterpret_cast<Four>((four & kind) == kind) & added;
        std::memcpy(to + i, &four, sizeof four);
    }
    for (; i < words.size(); ++i) to[i] = words[i] + ((words[i] & kind) != 0 ? added : 0);
}

}  // namespace

Result<Octree> TreeBuilder::finish(std::uint32_t root, glm::ivec3 size, glm::ivec3 origin,
                                   std::span<const TreeBuilder> parts, int threads) const {
    std::vector<const TreeBuilder*> builders{this};
    std::uint64_t nodes = nodeCount_;
    for (const TreeBuilder& part : parts) {
        builders.push_back(&part);
        nodes += part.nodeCount_ - 1;
    }
    if (nodes > kMaxOctreeNodes) return fail("the model needs more than 8,388,608 octree nodes");

    // Which level of whom is copied where, and by how much the words of one kind grow there: child
    // bases by what comes before the children, indices of payloads by the payloads before.
    struct Job {
        const Words* words;
        std::size_t at;
        std::uint32_t kind, added;
    };
    std::vector<Job> jobs;
    std::size_t payloads = 0;
    std::size_t at = 1;
    const int bricksDepth = maxDepth_ - 1;
    for (int depth = 1; depth <= bricksDepth; ++depth) {
        std::size_t children = at;
        for (const TreeBuilder* builder : builders) children += builder->nodesAt(depth);
        for (const TreeBuilder* builder : builders) {
            const auto added =
                static_cast<std::uint32_t>(depth < bricksDepth ? children << 8 : payloads);
            const Words& words = builder->levels_[static_cast<std::size_t>(depth)];
            jobs.push_back(
                {&words, at, depth < bricksDepth ? node::kInternal : node::kBrick, added});
            at += words.size();
            if (depth < bricksDepth) children += builder->nodesAt(depth + 1);
            if (depth == bricksDepth) payloads += builder->payloads_.size();
        }
    }

    Octree octree;
    octree.maxDepth = maxDepth_;
    octree.size = size;
    octree.origin = origin;
    octree.nodes.resize(static_cast<std::size_t>(nodes));
    octree.nodes[0] = node::isInternal(root) ? root + (1u << 8) : root;
    parallelFor(static_cast<int>(jobs.size()), threads, [&](int first, int last) {
        for (const Job& job : std::span(jobs).subspan(first, last - first)) {
            copyAdding(*job.words, job.kind, job.added, &octree.nodes[job.at]);
        }
    });
    octree.payloads.reserve(payloads);
    for (const TreeBuilder* builder : builders) {
        octree.payloads.insert(octree.payloads.end(), builder->payloads_.begin(),
                               builder->payloads_.end());
    }
    return octree;
}

namespace {

// Copies a shifted part of an octree. A cube of the copy lies across up to eight cubes of its own
// edge in the source (one where the shift is a multiple of the edge); going down, the eight that
// lie under a child are found among the children of those.
class Relayout {
  public:
    Relayout(const OctreeView& source, glm::ivec3 size)
        : source_(source), size_(size), builder_(depthForSize(size)) {}

    Result<Octree> run(glm::ivec3 shift, glm::ivec3 origin) {
        const int depth = builder_.maxDepth();
        const glm::ivec3 first = shift >> depth;
        Cover root;
        root.offset = shift - (first << depth);
        for (unsigned corner = 0; corner < 8; ++corner) {
            root.cells[corner] = locate(first + octantCorner(corner), depth);
        }
        return builder_.finish(cube(0, glm::ivec3(0), root), size_, origin);
    }

  private:
    // A cube of the source. With levelsAbove > 0 it is larger than the source's root, which then
    // fills the lowest corner of it, that many levels further down.
    struct Cell {
        std::uint32_t word = 0;
        int levelsAbove = 0;
    };
    // The source under a cube of the copy: the cube's minimum corner lies at `offset` in cells[0],
    // whose neighbours follow in octant order. Along an axis without offset only cells[0] counts.
    struct Cover {
        std::array<Cell, 8> cells;
        glm::ivec3 offset{0};
        [[nodiscard]] unsigned needed() const {  // corners that count are subsets of these bits
            return (offset.x != 0 ? 1u : 0u) | (offset.y != 0 ? 2u : 0u) |
                   (offset.z != 0 ? 4u : 0u);
        }
    };

    // The cell with edge 2^log2Edge at these multiples of it.
    [[nodiscard]] Cell locate(glm::ivec3 cell, int log2Edge) const {
        const int above = log2Edge - source_.maxDepth;
        const int cellsAnEdge = above >= 0 ? 1 : 1 << -above;
        if (!IBox{glm::ivec3(0), glm::ivec3(cellsAnEdge)}.contains(cell)) return {};
        if (above >= 0) return {source_.nodes[0], source_.nodes[0] == 0 ? 0 : above};
        Cell found{source_.nodes[0], 0};
        for (int bit = -above - 1; bit >= 0; --bit) found = child(found, octantOf(cell, bit));
        return found;
    }

    [[nodiscard]] Cell child(Cell cell, unsigned octant) const {
        if (cell.levelsAbove > 0)
            return octant == 0 ? Cell{cell.word, cell.levelsAbove - 1} : Cell{};
        if (!node::isInternal(cell.word)) return cell;  // uniform or empty all through
        if (!node::hasChild(cell.word, octant)) return {};
        return {source_.nodes[node::childIndex(cell.word, octant)], 0};
    }

    [[nodiscard]] std::uint32_t cube(int depth, glm::ivec3 min, const Cover& cover) {
        if (builder_.full()) return 0;
        const int edge = 1 << (builder_.maxDepth() - depth);
        const unsigned needed = cover.needed();
        bool same = cover.cells[0].levelsAbove == 0 && !node::isInternal(cover.cells[0].word) &&
                    !node::isBrick(cover.cells[0].word);
        for (unsigned corner = 1; same && corner < 8; ++corner) {
            if ((corner & ~needed) != 0) continue;
            same = cover.cells[corner].word == cover.cells[0].word &&
                   cover.cells[corner].levelsAbove == 0;
        }
        const glm::ivec3 end = glm::min(min + edge, size_);
        const bool inside = end == min + edge;
        if (same && (inside || node::isEmpty(cover.cells[0].word))) return cover.cells[0].word;
        if (end.x <= min.x || end.y <= min.y || end.z <= min.z) return 0;
        if (edge == 2) return builder_.brick(brickPayload(cover, min));

        const int half = edge / 2;
        return builder_.internal(depth, [&](unsigned octant) {
            const glm::ivec3 step = octantCorner(octant) * half;
            return cube(depth + 1, min + step, childCover(cover, cover.offset + step, half));
        });
    }

    [[nodiscard]] Cover childCover(const Cover& cover, glm::ivec3 at, int half) const {
        const glm::ivec3 upper(at.x >= half, at.y >= half, at.z >= half);
        // `at` may reach one and a half edges: then the first cell is the lower half of a
        // neighbour.
        const glm::ivec3 beyond(at.x >= 2 * half, at.y >= 2 * half, at.z >= 2 * half);
        const glm::ivec3 first = upper + beyond;  // in half edges
        Cover result;
        result.offset = at - first * half;
        const unsigned needed = result.needed();
        for (unsigned corner = 0; corner < 8; ++corner) {
            if ((corner & ~needed) != 0) continue;
            const glm::ivec3 halves = first + octantCorner(corner);
            result.cells[corner] = child(cover.cells[octantOf(halves, 1)], octantOf(halves, 0));
        }
        return result;
    }

    [[nodiscard]] std::uint64_t brickPayload(const Cover& cover, glm::ivec3 min) const {
        std::uint64_t payload = 0;
        for (unsigned octant = 0; octant < 8; ++octant) {
            const glm::ivec3 corner = octantCorner(octant);
            if (!IBox{glm::ivec3(0), size_}.contains(min + corner)) continue;
            const glm::ivec3 at = cover.offset + corner;
            const std::uint32_t word = cover.cells[octantOf(at, 1)].word;
            const std::uint64_t material =
                node::isBrick(word)
                    ? payloadMaterial(source_.payloads[node::payloadIndex(word)], octantOf(at, 0))
                    : word;
            payload |= material << (8 * octant);
        }
        return payload;
    }

    const OctreeView& source_;
    glm::ivec3 size_;
    TreeBuilder builder_;
};

}  // namespace

Result<Octree> relayout(const OctreeView& source, glm::ivec3 shift, glm::ivec3 size,
                        glm::ivec3 origin) {
    if (auto fits = checkOctreeSize(size); !fits) return tl::unexpected(fits.error());
    return Relayout(source, size).run(shift, origin);
}

}  // namespace voxprite
