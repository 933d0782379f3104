// How a line walks an octree, exactly: what castLattice and raycast share.
//
// The line is brought into tree space and turned so that it runs upward on every axis (see
// Course::flip). On axis a it then crosses face k at the time (k 2^P - O_a) / D_a. Times become
// integers on their common denominator D_x D_y D_z, and the axis, which decides between equal
// times, becomes their last two bits:
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
//      go on from there (Laine & Karras 2010).
//
// A walk may end above the voxels: nodes of edge 2^leafLevel that hold anything are then solid
// cubes, for a line that has no need of more detail.
//
// 64 bits are enough: a key needs two bits more than the distance of a face from the ray's start
// and twice the direction's bits. Distances on a lattice that pixelBounds accepts stay below 2^31
// and D has 13 bits: 31 + 26 + 2 = 59. Those of quantiseRay stay below 2^22 (half of it on all but
// the smallest roots) and D has 19 bits: 22 + 38 + 2 = 62.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/svo/octree.h"

namespace voxprite {

struct LatticeHit {
    std::uint8_t material = 0;  // 0: nothing was hit
    // The axis whose face the ray came through (0 x, 1 y, 2 z). The face's outward normal points
    // against D on that axis.
    std::uint8_t faceAxis = 0;
    glm::ivec3 voxel{0};  // the minimum corner of a leaf of several voxels
};

using AxisKeys = std::array<std::int64_t, 3>;
using AxisCells = std::array<std::uint32_t, 3>;

// Later than every crossing there is.
inline constexpr std::int64_t kNever = std::int64_t{1} << 62;

// The part of the model's box that lies inside the root cube, in voxel coordinates: nothing else
// can be solid. Grown to whole nodes of edge 2^leafLevel. Empty when there is nothing to hit.
[[nodiscard]] IBox castableBox(const OctreeView& octree, int leafLevel = 0);

// The material of a node taken for a leaf: that of its first solid voxel, octant by octant in their
// order, depth first. 0 of an empty one. O(depth).
[[nodiscard]] std::uint8_t firstMaterial(const OctreeView& octree, std::uint32_t word);

// What all lines along one direction share: the octree as they see it.
struct Course {
    // A direction of (0,0,0) makes lines that hit nothing.
    Course(const OctreeView& octree, glm::ivec3 direction, int positionBits, int leafLevel = 0);

    OctreeView octree;
    int positionBits = 0;
    int leafLevel = 0;      // 0 ... octree.maxDepth
    bool castable = false;  // there is something to hit
    // Tree coordinate = walk coordinate ^ flip. Where lines run downward all bits flip, which
    // mirrors the root cube.
    AxisCells flip{};
    std::array<bool, 3> still{};  // direction 0
    IBox box;                     // the castable box in tree coordinates
    // Of the line through the root's minimum corner; the keys of another are less by perStep for
    // every lattice step that its origin is off.
    AxisKeys faceZero{};  // key_a(0)
    AxisKeys perStep{};   // 4 W, negative where mirrored
    // The same for all lines.
    AxisKeys perCell{};   // key_a(k + 1) - key_a(k)
    AxisKeys boxEnter{};  // key_a(k) - key_a(0) for the castable box's lower and upper face k
    AxisKeys boxLeave{};
};

// One of those lines.
struct Line {
    // `origin` in lattice units from the root's minimum corner.
    Line(const Course& course, const glm::i64vec3& origin);

    AxisKeys faceZero{};  // key_a(0)
    // As the course's, but where the line does not move at all its cell: there it stays at walk
    // coordinate 0, whose upper face it never crosses.
    AxisCells flip{};
    // The keys by which the line enters and leaves the castable box; a miss unless enter < leave.
    std::int64_t enter = -kNever;
    std::int64_t leave = kNever;
};

// The first solid voxel from the cell onward that lies behind the crossing `key` (at least
// line.enter). The hit's faceAxis is the last two bits of the key of the crossing into it.
[[nodiscard]] LatticeHit walk(const Course& course, const Line& line, std::int64_t key);

// What a walk cost, and a bound on it.
struct WalkCount {
    std::uint64_t mostIterations = 0;
    std::uint64_t iterations = 0;  // leaves looked at, one after the other along the line
    std::uint64_t nodes = 0;       // words read on the way down to them
    bool stopped = false;          // the next iteration would have been one too many
};
// The same, counted; a walk that is stopped hits nothing.
[[nodiscard]] LatticeHit walk(const Course& course, const Line& line, std::int64_t key,
                              WalkCount& count);

}  // namespace voxprite
