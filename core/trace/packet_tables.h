// What all packets of one lattice share: see core/trace/packet_caster.h for what it is for.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/base/box.h"
#include "core/svo/octree.h"
#include "core/trace/lattice.h"

namespace voxprite {

// The pairs of axes (0,1), (0,2), (1,2).
inline constexpr int kPairFirst[3] = {0, 0, 1};
inline constexpr int kPairSecond[3] = {1, 2, 2};

using EightInts = std::array<std::int32_t, 8>;
using EightWords = std::array<std::uint32_t, 8>;

// For the children of edge 2^level, by their octant in walk order (upper halves set).
struct PacketLevel {
    // From the parent's centre, in fixed-point pixels: to a child's centre, and to the bounds that
    // its first pixel (rounded up) and its last (rounded down) come from by a shift.
    alignas(32) EightInts centreI, centreJ;
    alignas(32) EightInts lowI, highI, lowJ, highJ;
};

// Does a ray meet a voxel, by pair of axes: with x = G - corner, where `corner` is 2^P (k[a] D[b] -
// k[b] D[a]) of the brick's corner k plus this one by octant in walk order, all modulo 2^32 and x
// as a signed integer, it does where x < end, and crosses the second axis's lower face after the
// first one's where x >= middle.
struct VoxelTest {
    std::array<EightWords, 3> corner;
    std::array<std::int32_t, 3> middle, end;
};

// An octree as rays see it that run upward on every axis.
struct PacketTree {
    PacketTree() = default;
    // `box` is the castable box in tree coordinates; `mirrored` are the axes along which the rays
    // run downward.
    PacketTree(const OctreeView& octree, const IBox& box, glm::bvec3 mirrored, int leafLevel);

    OctreeView octree;
    int leafLevel = 0;                         // its nodes that hold anything are solid cubes
    IBox box;                                  // the castable box, walk coordinates
    glm::uvec3 flip{0};                        // tree coordinate = walk coordinate ^ flip
    unsigned flipOctant = 0;                   // octant = octant in walk order ^ flipOctant
    std::array<std::uint8_t, 256> walkMask{};  // an eight-bit mask of octants in walk order
};

struct PacketTables {
    // Nothing for a lattice whose numbers do not fit.
    [[nodiscard]] static std::optional<PacketTables> of(const OctreeView& octree,
                                                        const LatticeView& lattice);

    std::array<PacketLevel, kMaxOctreeDepth> levels;
    double rootI = 0, rootJ = 0;  // the root's centre in pixels
    PacketTree tree;
    VoxelTest voxelTest;
    int fractionBits = 0;  // of fixed-point pixels

    // A ray's start modulo 2^32, mirrored: C + (i U + j V) >> kStepShift with what lies above and
    // below the shift kept apart.
    int positionBits = 0;
    glm::ivec3 C{0}, U{0}, V{0};  // C from the root's minimum corner; not mirrored
    glm::uvec3 D{0};              // mirrored: never negative
};

}  // namespace voxprite
