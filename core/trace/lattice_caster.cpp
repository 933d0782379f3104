#include "core/trace/lattice_caster.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <utility>

// How the walk works
//
// The line is brought into tree space and turned so that it runs upward on every axis (see flip).
// On axis a it then crosses face k at the time (k 2^P - O_a) / D_a. Times become integers on their
// common denominator D_x D_y D_z, and the axis, which decides between equal times, becomes their
// last two bits:
//
//     key_a(k) = 4 W_a (k 2^P - O_a) + a,    W_a = the product of the other two components of D.
//
// So the order of all crossings that core/trace/lattice.h asks for is the order of plain integers,
// the walk's whole state is the key of the last crossing, and a cell's lower faces are those with
// keys up to it. Finding the cell, skipping an empty node and leaving the box take no division and
// no rule for ties:
//
//   1. Descend the octree: the cell is in the upper half of a node where the key of the plane
//      through its middle is no more than the last crossing's. A solid leaf is the hit.
//   2. An empty node is left by the least key of its three upper faces, unless that comes after the
//      line has left the box.
//   3. The highest bit that this changes in the coordinate tells which ancestor holds both nodes;
//   go
//      on from there (Laine & Karras 2010).
//
// 64 bits are enough: a key needs two bits more than the distance of a face from the ray's start
// and twice the direction's bits. Distances on a lattice that pixelBounds accepts stay below 2^31
// and D has 13 bits: 31 + 26 + 2 = 59. Perspective rays choose their bits to fit.

namespace voxprite {
namespace {

using Axes = std::array<std::int64_t, 3>;

// Later than every crossing there is.
constexpr std::int64_t kNever = std::int64_t{1} << 62;
// Bits of edge, position and twice the direction together; a sign, the key's two bits and one for
// starts outside the box complete the 64.
constexpr int kPerspectiveBits = 59;

// The part of the model's box that lies inside the root cube, in voxel coordinates: nothing else
// can be solid. Empty when there is nothing to hit.
IBox castableBox(const OctreeView& octree) {
    if (node::isEmpty(octree.nodes[0])) return {};
    const IBox root{-octree.treeFromVoxel, (1 << octree.maxDepth) - octree.treeFromVoxel};
    return IBox{glm::ivec3(0), octree.size}.intersected(root);
}

struct Line {
    Axes faceZero{};  // key_a(0)
    Axes perCell{};   // key_a(k + 1) - key_a(k)
    // Tree coordinate = walk coordinate ^ flip. Where the line runs downward all bits flip, which
    // mirrors the root cube. Where it does not move at all the flip is its cell: it stays at 0 and
    // crosses nothing, ever.
    std::array<std::uint32_t, 3> flip{};
    // The keys by which the line enters and leaves the castable box.
    std::int64_t enter = kNever;
    std::int64_t leave = kNever;
};

Line lineInTree(const OctreeView& octree, const IBox& box, const LatticeRay& ray) {
    Line line;
    line.enter = -kNever;
    const std::int64_t rootEdge = std::int64_t{1} << octree.maxDepth;
    for (int a = 0; a < 3; ++a) {
        const std::int64_t direction = ray.direction[a];
        std::int64_t origin =
            ray.origin[a] + (std::int64_t{octree.treeFromVoxel[a]} << ray.positionBits);
        std::int64_t boxMin = box.min[a] + octree.treeFromVoxel[a];
        std::int64_t boxMax = box.max[a] + octree.treeFromVoxel[a];
        if (direction == 0) {
            const std::int64_t cell = origin >> ray.positionBits;
            line.flip[a] = static_cast<std::uint32_t>(cell);
            line.faceZero[a] = kNever;
            if (cell < boxMin || cell >= boxMax) line.enter = kNever;
            continue;
        }
        if (direction < 0) {
            line.flip[a] = static_cast<std::uint32_t>(rootEdge - 1);
            origin = (rootEdge << ray.positionBits) - origin;
            boxMin = rootEdge - std::exchange(boxMax, rootEdge - boxMin);
        }
        std::int64_t weight = 4;
        for (int b = 0; b < 3; ++b)
            if (b != a && ray.direction[b] != 0) weight *= std::abs(ray.direction[b]);
        line.faceZero[a] = a - weight * origin;
        line.perCell[a] = weight << ray.positionBits;
        line.enter = std::max(line.enter, line.faceZero[a] + boxMin * line.perCell[a]);
        line.leave = std::min(line.leave, line.faceZero[a] + boxMax * line.perCell[a]);
    }
    return line;
}

// The child of an internal node, a brick or a uniform leaf, whose children are like itself.
std::uint32_t childOf(const OctreeView& octree, std::uint32_t word, unsigned octant) {
    if (node::isInternal(word))
        return node::hasChild(word, octant) ? octree.nodes[node::childIndex(word, octant)] : 0;
    if (node::isBrick(word))
        return payloadMaterial(octree.payloads[node::payloadIndex(word)], octant);
    return word;
}

// The first solid voxel from the cell onward that lies behind the crossing `key`.
LatticeHit walk(const OctreeView& octree, const Line& line, std::int64_t key) {
    std::array<std::uint32_t, kMaxOctreeDepth + 1> path;  // the node of edge 2^level, by level
    int level = octree.maxDepth;
    path[level] = octree.nodes[0];
    std::array<std::uint32_t, 3> corner{};  // of the node at `level`, in walk coordinates
    while (key < line.leave) {
        std::uint32_t word = path[level];
        Axes cornerKey;
        for (int a = 0; a < 3; ++a) cornerKey[a] = line.faceZero[a] + corner[a] * line.perCell[a];
        while (!node::isEmpty(word) && level > 0) {
            --level;
            unsigned octant = 0;
            for (int a = 0; a < 3; ++a) {
                const std::int64_t middleKey = cornerKey[a] + (line.perCell[a] << level);
                const bool upper = middleKey <= key;
                cornerKey[a] = upper ? middleKey : cornerKey[a];
                corner[a] |= std::uint32_t{upper} << level;
                octant |= ((corner[a] ^ line.flip[a]) >> level & 1u) << a;
            }
            word = childOf(octree, word, octant);
            path[level] = word;
        }
        if (!node::isEmpty(word)) {
            LatticeHit hit;
            hit.material = static_cast<std::uint8_t>(word);
            hit.faceAxis = static_cast<std::uint8_t>(key & 3);
            for (int a = 0; a < 3; ++a)
                hit.voxel[a] = static_cast<int>(corner[a] ^ line.flip[a]) - octree.treeFromVoxel[a];
            return hit;
        }
        key = kNever;
        for (int a = 0; a < 3; ++a) key = std::min(key, cornerKey[a] + (line.perCell[a] << level));
        if (key >= line.leave) return {};
        const auto axis = static_cast<std::size_t>(key & 3);
        const std::uint32_t face = corner[axis] + (1u << level);
        level = static_cast<int>(std::bit_width(corner[axis] ^ face));
        corner[axis] = face;
        for (std::uint32_t& c : corner) c = c >> level << level;
    }
    return {};
}

}  // namespace

LatticeRay rayOf(const LatticeView& lattice, glm::ivec2 pixel) {
    LatticeRay ray;
    ray.positionBits = lattice.positionBits;
    ray.direction = lattice.D;
    for (int a = 0; a < 3; ++a) {
        const std::int64_t step =
            std::int64_t{pixel.x} * lattice.U[a] + std::int64_t{pixel.y} * lattice.V[a];
        ray.origin[a] = lattice.C[a] + (step >> kStepShift);
    }
    return ray;
}

LatticeHit castLattice(const OctreeView& octree, const LatticeRay& ray) {
    const IBox box = castableBox(octree);
    if (box.empty()) return {};
    const Line line = lineInTree(octree, box, ray);
    return walk(octree, line, line.enter);
}

PerspectiveHit castPerspective(const OctreeView& octree, glm::dvec3 eye, glm::dvec3 direction) {
    const IBox box = castableBox(octree);
    const auto finite = [](glm::dvec3 v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    if (box.empty() || !finite(eye) || !finite(direction)) return {};
    int largest = 0;
    for (int a = 1; a < 3; ++a)
        if (std::abs(direction[a]) > std::abs(direction[largest])) largest = a;
    if (direction[largest] == 0.0) return {};
    const glm::dvec3 scaled = direction / std::abs(direction[largest]);

    // Where the ray enters the box, if the eye is outside.
    bool inside = true;
    double enter = 0.0;
    for (int a = 0; a < 3; ++a) {
        const bool below = eye[a] < box.min[a];
        const bool above = eye[a] >= box.max[a];
        if (!below && !above) continue;
        inside = false;
        if (below ? scaled[a] <= 0.0 : scaled[a] >= 0.0) return {};
        enter = std::max(enter, ((below ? box.min[a] : box.max[a]) - eye[a]) / scaled[a]);
    }
    const glm::dvec3 start = eye + scaled * enter;

    const glm::ivec3 edges = box.size();
    const int edgeBits = static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({edges.x, edges.y, edges.z}))));
    LatticeRay ray;
    ray.positionBits = std::max(8, 21 - edgeBits);
    const int directionBits = (kPerspectiveBits - edgeBits - ray.positionBits) / 2;
    for (int a = 0; a < 3; ++a) {
        // Rounding moves the line by far less than a voxel: it would miss as well.
        if (!(start[a] >= box.min[a] - 1.0 && start[a] <= box.max[a] + 1.0)) return {};
        ray.origin[a] = std::llround(std::ldexp(start[a], ray.positionBits));
        ray.direction[a] = static_cast<int>(std::lround(std::ldexp(scaled[a], directionBits)));
    }

    const Line line = lineInTree(octree, box, ray);
    // From inside, every crossing up to the eye (time 0) has been made; axis 3 stands for the eye.
    constexpr std::int64_t kAtEye = 3;
    PerspectiveHit result;
    result.hit = walk(octree, line, inside ? std::max(line.enter, kAtEye) : line.enter);
    if (result.hit.material == 0) return result;
    if (result.hit.faceAxis == kAtEye) {
        result.hit.faceAxis = static_cast<std::uint8_t>(largest);
        return result;
    }
    const int axis = result.hit.faceAxis;
    const int face = result.hit.voxel[axis] + (direction[axis] < 0.0 ? 1 : 0);
    result.t = std::max(0.0, (face - eye[axis]) / scaled[axis]) * glm::length(scaled);
    return result;
}

}  // namespace voxprite
