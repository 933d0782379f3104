#include "core/trace/lattice_caster.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

// How the walk works
//
// The line is brought into tree space and mirrored so that it runs upward on every axis. From then
// on its state is two things: the cell it is in, and the axis of the crossing that brought it
// there.
//
//   1. Descend the octree along the cell's bits. A solid leaf is the hit.
//   2. Otherwise an empty node holds the cell. Of its three upper faces (cut to the model's box)
//   the
//      one crossed first is the way out; that is a comparison of products, and equal times go to
//      the lower axis.
//   3. Every other axis has made some crossings before that one: one floor division counts them.
//   4. The new cell's highest changed bit tells which ancestor holds both cells; go on from there.
//
// 64 bits are enough. A model's edge takes 16 bits, so a sprite's faces and starts (P <= 10) take
// 28 with the buffer's corners, their products with D (13 bits) 41, and the sum of two of them 42.
// A perspective ray (P = 16, D of 24 bits) starts beside its box: 33 + 24 + 1 = 58. A foreign
// lattice that pixelBounds accepts (C, U, V within 2^28, pixels within 2^24, D of 16 bits) starts
// within 2^42: 42 + 16 + 1 = 59.

namespace voxprite {
namespace {

using Axes = std::array<std::int64_t, 3>;

constexpr int kPerspectivePositionBits = 16;
constexpr int kPerspectiveDirectionBits = 24;

// Rounds down; the denominator is positive.
std::int64_t floorDiv(std::int64_t numerator, std::int64_t denominator) {
    return numerator / denominator - (numerator % denominator < 0);
}

// The part of the model's box that lies inside the root cube, in voxel coordinates: nothing else
// can be solid. Empty when there is nothing to hit.
IBox castableBox(const OctreeView& octree) {
    if (node::isEmpty(octree.nodes[0])) return {};
    const IBox root{-octree.treeFromVoxel, (1 << octree.maxDepth) - octree.treeFromVoxel};
    return IBox{glm::ivec3(0), octree.size}.intersected(root);
}

// A line in tree space, mirrored on the axes where it ran downward, and the castable box likewise.
struct Line {
    Axes origin{};     // lattice units
    Axes direction{};  // >= 0
    Axes boxMin{};     // cells
    Axes boxMax{};
    int positionBits = 0;
    unsigned mirrored = 0;  // bit a: axis a, which is also the octants' bit
};

// Mirroring maps cell c to 2^maxDepth - 1 - c, that is, it flips the octants' bits.
Line lineInTree(const OctreeView& octree, const LatticeRay& ray) {
    Line line;
    line.positionBits = ray.positionBits;
    const std::int64_t rootEdge = std::int64_t{1} << octree.maxDepth;
    const IBox box = castableBox(octree);
    for (int a = 0; a < 3; ++a) {
        const std::int64_t offset = octree.treeFromVoxel[a];
        line.origin[a] = ray.origin[a] + (offset << ray.positionBits);
        line.direction[a] = ray.direction[a];
        line.boxMin[a] = box.min[a] + offset;
        line.boxMax[a] = box.max[a] + offset;
        if (ray.direction[a] < 0) {
            line.mirrored |= 1u << a;
            line.origin[a] = (rootEdge << ray.positionBits) - line.origin[a];
            line.direction[a] = -line.direction[a];
            const std::int64_t boxMin = line.boxMin[a];
            line.boxMin[a] = rootEdge - line.boxMax[a];
            line.boxMax[a] = rootEdge - boxMin;
        } else if (ray.direction[a] == 0) {
            // Off the faces, in the same cell: no formula below needs a special case.
            line.origin[a] |= 1;
        }
    }
    return line;
}

// The crossing of the face at cell coordinate `face`, as a distance along its axis; its time is
// distance / direction[axis].
std::int64_t distanceTo(const Line& line, int axis, std::int64_t face) {
    return (face << line.positionBits) - line.origin[axis];
}

// Which of three faces, one an axis, is crossed first or last in the order of (time, axis). An axis
// without direction has a positive distance to a face above and a negative one to a face below the
// line, so its time counts as +-infinity and another axis wins.
int firstCrossed(const Line& line, const Axes& distance) {
    const Axes& d = line.direction;
    int axis = 0;
    if (distance[1] * d[0] < distance[0] * d[1]) axis = 1;
    if (distance[2] * d[axis] < distance[axis] * d[2]) axis = 2;
    return axis;
}

int lastCrossed(const Line& line, const Axes& distance) {
    const Axes& d = line.direction;
    int axis = 0;
    if (distance[1] * d[0] >= distance[0] * d[1]) axis = 1;
    if (distance[2] * d[axis] >= distance[axis] * d[2]) axis = 2;
    return axis;
}

// The cell on axis `other` right after the crossing on `axis`: the count of other's faces crossed
// until then, those at the very same time included if other comes before axis.
std::int64_t cellAfter(const Line& line, int axis, std::int64_t distance, int other) {
    const std::int64_t scaledPosition =
        line.origin[other] * line.direction[axis] + distance * line.direction[other];
    return floorDiv(scaledPosition - (other > axis), line.direction[axis] << line.positionBits);
}

// Walks on from a cell inside the box; `axis` is that of the crossing into it.
LatticeHit walk(const OctreeView& octree, const Line& line, Axes cell, int axis) {
    std::array<std::uint32_t, kMaxOctreeDepth + 1>
        path;  // the node of edge 2^level around the cell
    int level = octree.maxDepth;
    path[level] = octree.nodes[0];
    for (;;) {
        std::uint32_t word = path[level];
        while (node::isInternal(word) || node::isBrick(word)) {
            --level;
            const unsigned octant =
                line.mirrored ^
                static_cast<unsigned>(((cell[2] >> level & 1) << 2) |
                                      ((cell[1] >> level & 1) << 1) | (cell[0] >> level & 1));
            if (node::isBrick(word)) {
                word = payloadMaterial(octree.payloads[node::payloadIndex(word)], octant);
            } else if (node::hasChild(word, octant)) {
                word = octree.nodes[node::childIndex(word, octant)];
            } else {
                word = 0;
            }
            path[level] = word;
        }
        if (!node::isEmpty(word)) {
            LatticeHit hit;
            hit.material = static_cast<std::uint8_t>(word);
            hit.faceAxis = static_cast<std::uint8_t>(axis);
            for (int a = 0; a < 3; ++a) {
                const std::int64_t treeCell =
                    (line.mirrored >> a & 1) != 0
                        ? (std::int64_t{1} << octree.maxDepth) - 1 - cell[a]
                        : cell[a];
                hit.voxel[a] = static_cast<int>(treeCell) - octree.treeFromVoxel[a];
            }
            return hit;
        }

        Axes face;
        Axes distance;
        for (int a = 0; a < 3; ++a) {
            face[a] = std::min(((cell[a] >> level) + 1) << level, line.boxMax[a]);
            distance[a] = distanceTo(line, a, face[a]);
        }
        axis = firstCrossed(line, distance);
        if (face[axis] == line.boxMax[axis]) return {};

        std::int64_t changed = 0;
        for (int a = 0; a < 3; ++a) {
            if (a != axis && level == 0) continue;  // a voxel is left on one axis alone
            const std::int64_t next =
                a == axis ? face[a] : cellAfter(line, axis, distance[axis], a);
            changed |= cell[a] ^ next;
            cell[a] = next;
        }
        level = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(changed)));
    }
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
    if (castableBox(octree).empty() || ray.direction == glm::ivec3(0)) return {};
    const Line line = lineInTree(octree, ray);

    // The line enters the box with the last of the crossings of its three lower faces.
    Axes distance;
    for (int a = 0; a < 3; ++a) {
        distance[a] = distanceTo(line, a, line.boxMin[a]);
        if (line.direction[a] == 0 && (distance[a] > 0 || distanceTo(line, a, line.boxMax[a]) <= 0))
            return {};
    }
    const int axis = lastCrossed(line, distance);
    Axes cell;
    for (int a = 0; a < 3; ++a) {
        cell[a] = a == axis ? line.boxMin[a] : cellAfter(line, axis, distance[axis], a);
        if (cell[a] >= line.boxMax[a]) return {};
    }
    return walk(octree, line, cell, axis);
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

    LatticeRay ray;
    ray.positionBits = kPerspectivePositionBits;
    for (int a = 0; a < 3; ++a) {
        // Rounding moves the line by far less than a voxel: it would miss as well.
        if (!(start[a] >= box.min[a] - 1.0 && start[a] <= box.max[a] + 1.0)) return {};
        ray.origin[a] = std::llround(std::ldexp(start[a], kPerspectivePositionBits));
        ray.direction[a] =
            static_cast<int>(std::lround(std::ldexp(scaled[a], kPerspectiveDirectionBits)));
    }

    PerspectiveHit result;
    if (inside) {
        // Every face up to the eye counts as crossed.
        const Line line = lineInTree(octree, ray);
        Axes cell;
        for (int a = 0; a < 3; ++a) {
            cell[a] = line.origin[a] >> line.positionBits;
            if (cell[a] < line.boxMin[a] || cell[a] >= line.boxMax[a]) return {};
        }
        result.hit = walk(octree, line, cell, largest);
    } else {
        result.hit = castLattice(octree, ray);
    }
    if (result.hit.material == 0) return result;
    const int axis = result.hit.faceAxis;
    const int face = result.hit.voxel[axis] + (direction[axis] < 0.0 ? 1 : 0);
    const double steps = (face - eye[axis]) / scaled[axis];
    // An eye inside the hit voxel has its face behind it.
    result.t = std::max(steps, 0.0) * std::sqrt(glm::dot(scaled, scaled));
    return result;
}

}  // namespace voxprite
