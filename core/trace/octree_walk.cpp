#include "core/trace/octree_walk.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace voxprite {
namespace {

// Calls body(0), body(1), body(2): a loop over the axes that is always unrolled.
template <class Body>
void eachAxis(const Body& body) {
    body(0);
    body(1);
    body(2);
}

// The child of an internal node, a brick or a uniform leaf, whose children are like itself.
std::uint32_t childOf(const OctreeView& octree, std::uint32_t word, unsigned octant) {
    if (node::isInternal(word))
        return node::hasChild(word, octant) ? octree.nodes[node::childIndex(word, octant)] : 0;
    if (node::isBrick(word))
        return payloadMaterial(octree.payloads[node::payloadIndex(word)], octant);
    return word;
}

// What counts nothing costs nothing.
struct Uncounted {
    static bool iterate() { return true; }
    static void descend() {}
};

struct Counted {
    WalkCount& count;
    [[nodiscard]] bool iterate() const {
        count.stopped = count.iterations == count.mostIterations;
        count.iterations += count.stopped ? 0 : 1;
        return !count.stopped;
    }
    void descend() const { ++count.nodes; }
};

template <class Watch>
LatticeHit walkWatched(const Course& course, const Line& line, std::int64_t key,
                       const Watch& watch) {
    if (key >= line.leave || !course.castable) return {};
    const OctreeView& octree = course.octree;
    std::array<std::uint32_t, kMaxOctreeDepth + 1> path;  // the node of edge 2^level, by level
    int level = octree.maxDepth;
    path[level] = octree.nodes[0];
    AxisCells corner{};  // of the node at `level`, in walk coordinates
    while (watch.iterate()) {
        std::uint32_t word = path[level];
        AxisKeys cornerKey;
        eachAxis([&](int a) { cornerKey[a] = line.faceZero[a] + corner[a] * course.perCell[a]; });
        while (!node::isEmpty(word) && level > course.leafLevel) {
            --level;
            watch.descend();
            unsigned octant = 0;
            eachAxis([&](int a) {
                const std::int64_t middleKey = cornerKey[a] + (course.perCell[a] << level);
                const bool upper = middleKey <= key;
                cornerKey[a] = upper ? middleKey : cornerKey[a];
                corner[a] |= std::uint32_t{upper} << level;
                octant |= ((corner[a] ^ line.flip[a]) >> level & 1u) << a;
            });
            word = childOf(octree, word, octant);
            path[level] = word;
        }
        if (!node::isEmpty(word)) {
            LatticeHit hit;
            hit.material = course.leafLevel == 0 ? static_cast<std::uint8_t>(word)
                                                 : firstMaterial(octree, word);
            hit.faceAxis = static_cast<std::uint8_t>(key & 3);
            eachAxis([&](int a) {
                const std::uint32_t cell = (corner[a] ^ line.flip[a]) >> level << level;
                hit.voxel[a] = static_cast<int>(cell) - octree.treeFromVoxel[a];
            });
            return hit;
        }

        AxisKeys exit;
        eachAxis([&](int a) { exit[a] = cornerKey[a] + (course.perCell[a] << level); });
        key = std::min(exit[0], std::min(exit[1], exit[2]));
        if (key >= line.leave) return {};
        // Upward to the ancestor in which the crossed face is a middle plane. Its descent finds the
        // node behind the face, for that face's key is the last crossing now.
        const std::uint32_t crossed = corner[static_cast<std::size_t>(key & 3)];
        level += 1 + std::countr_one(crossed >> level);
        eachAxis([&](int a) { corner[a] = corner[a] >> level << level; });
    }
    return {};
}

}  // namespace

std::uint8_t firstMaterial(const OctreeView& octree, std::uint32_t word) {
    // The children that exist stand in octant order, and none of them is empty.
    while (node::isInternal(word)) word = octree.nodes[node::childBase(word)];
    if (!node::isBrick(word)) return static_cast<std::uint8_t>(word);
    const std::uint64_t payload = octree.payloads[node::payloadIndex(word)];
    return payloadMaterial(payload, static_cast<unsigned>(std::countr_zero(payload)) / 8);
}

IBox castableBox(const OctreeView& octree, int leafLevel) {
    if (node::isEmpty(octree.nodes[0])) return {};
    const IBox root{-octree.treeFromVoxel, (1 << octree.maxDepth) - octree.treeFromVoxel};
    IBox box = IBox{glm::ivec3(0), octree.size}.intersected(root);
    if (leafLevel == 0 || box.empty()) return box;
    const glm::ivec3 first = (box.min + octree.treeFromVoxel) >> leafLevel;
    const glm::ivec3 last = (box.max - 1 + octree.treeFromVoxel) >> leafLevel;
    return {(first << leafLevel) - octree.treeFromVoxel,
            ((last + 1) << leafLevel) - octree.treeFromVoxel};
}

Course::Course(const OctreeView& view, glm::ivec3 direction, int bits, int level)
    : octree(view), positionBits(bits), leafLevel(level) {
    box = castableBox(octree, leafLevel);
    castable = !box.empty() && direction != glm::ivec3(0);
    box.min += octree.treeFromVoxel;
    box.max += octree.treeFromVoxel;
    const std::int64_t rootEdge = std::int64_t{1} << octree.maxDepth;
    eachAxis([&](int a) {
        still[a] = direction[a] == 0;
        if (still[a]) {
            faceZero[a] = kNever;
            return;
        }
        std::int64_t weight = 4;
        eachAxis([&](int b) {
            if (b != a && direction[b] != 0) weight *= std::abs(direction[b]);
        });
        perCell[a] = weight << bits;
        const bool mirrored = direction[a] < 0;
        flip[a] = mirrored ? static_cast<std::uint32_t>(rootEdge - 1) : 0;
        perStep[a] = mirrored ? -weight : weight;
        faceZero[a] = a - (mirrored ? rootEdge * perCell[a] : 0);
        boxEnter[a] = (mirrored ? rootEdge - box.max[a] : box.min[a]) * perCell[a];
        boxLeave[a] = (mirrored ? rootEdge - box.min[a] : box.max[a]) * perCell[a];
    });
}

Line::Line(const Course& course, const glm::i64vec3& origin)
    : faceZero(course.faceZero), flip(course.flip) {
    eachAxis([&](int a) {
        if (course.still[a]) {
            const std::int64_t cell = origin[a] >> course.positionBits;
            flip[a] = static_cast<std::uint32_t>(cell);
            if (cell < course.box.min[a] || cell >= course.box.max[a]) leave = -kNever;
        } else {
            faceZero[a] -= course.perStep[a] * origin[a];
            enter = std::max(enter, faceZero[a] + course.boxEnter[a]);
            leave = std::min(leave, faceZero[a] + course.boxLeave[a]);
        }
    });
}

LatticeHit walk(const Course& course, const Line& line, std::int64_t key) {
    return walkWatched(course, line, key, Uncounted{});
}

LatticeHit walk(const Course& course, const Line& line, std::int64_t key, WalkCount& count) {
    return walkWatched(course, line, key, Counted{count});
}

}  // namespace voxprite
