#include "core/trace/packet_tables.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/trace/octree_walk.h"

namespace voxprite {
namespace {

constexpr int kMostFractionBits = 16;
constexpr int kFewestFractionBits = 4;
// Fixed-point pixels stay well within 32 bits, sums of two of them included.
constexpr double kMostFixed = 1 << 29;
// Fixed-point centres are off by half a unit a level, and the root's by one.
constexpr double kFixedSlack = 0.5 * kMaxOctreeDepth + 2.0;

__extension__ using Int128 = __int128;

using Axes = std::array<double, 3>;

// A pixel coordinate of points: that of the root's centre, and what a voxel along each axis adds.
struct PixelAxis {
    double rootCentre = 0;
    Axes perVoxel{};
};

// A ray starts at O = C + (iU + jV) / 2^kStepShift - e, 0 <= e < 1 on every axis. Where it runs
// through X, the product with a normal of V and D (for i; of D and U for j) leaves one coordinate:
// normal . (X + e - C) = i * determinant / 2^kStepShift. `e` is taken for half a step here, and
// grows the bounds by as much.
PixelAxis pixelAxis(const LatticeView& lattice, glm::ivec3 C, int maxDepth,
                    const Int128 (&normal)[3], Int128 determinant) {
    PixelAxis axis;
    const double scale = std::ldexp(1.0, kStepShift) / static_cast<double>(determinant);
    Int128 twice = 0;
    for (int a = 0; a < 3; ++a) {
        const Int128 edge = Int128{1} << (lattice.positionBits + maxDepth);
        twice += normal[a] * (edge + 1 - 2 * Int128{C[a]});
        axis.perVoxel[static_cast<std::size_t>(a)] =
            static_cast<double>(normal[a]) * scale * std::ldexp(1.0, lattice.positionBits);
    }
    axis.rootCentre = static_cast<double>(twice) * scale / 2.0;
    return axis;
}

double sumOfMagnitudes(const Axes& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

// A node's half width in pixels, the half step of a ray's rounding included.
double radiusOf(const PixelAxis& axis, int level, int positionBits) {
    return sumOfMagnitudes(axis.perVoxel) *
           (std::ldexp(0.5, level) + std::ldexp(0.5, -positionBits));
}

void fillBounds(const PixelAxis& axis, int level, int positionBits, int fractionBits,
                EightInts& centre, EightInts& low, EightInts& high) {
    const double radius =
        std::ceil(std::ldexp(radiusOf(axis, level, positionBits), fractionBits)) + kFixedSlack;
    const double halfEdge = std::ldexp(0.5, level + fractionBits);
    for (unsigned w = 0; w < 8; ++w) {
        double offset = 0.0;
        for (unsigned a = 0; a < 3; ++a)
            offset += axis.perVoxel[a] * ((w >> a & 1u) != 0 ? halfEdge : -halfEdge);
        centre[w] = static_cast<std::int32_t>(std::lround(offset));
        low[w] = centre[w] - static_cast<std::int32_t>(radius) + (1 << fractionBits) - 1;
        high[w] = centre[w] + static_cast<std::int32_t>(radius);
    }
}

// False when 32 bits are too few to tell a voxel's pixels from others of its rectangle.
bool fillVoxelTest(const LatticeView& lattice, PacketTables& tables) {
    const PacketLevel& voxels = tables.levels[0];
    const double unit = std::ldexp(1.0, -tables.fractionBits);
    // At least half a rectangle's width and height.
    const double width = unit * (voxels.highI[0] - voxels.lowI[0]) + 2.0;
    const double height = unit * (voxels.highJ[0] - voxels.lowJ[0]) + 2.0;
    for (std::size_t p = 0; p < 3; ++p) {
        const int a = kPairFirst[p];
        const int b = kPairSecond[p];
        const std::uint32_t below = tables.D[a] << lattice.positionBits;
        // A pair of axes along which nothing moves decides nothing.
        const std::uint32_t range =
            std::max((tables.D[a] + tables.D[b]) << lattice.positionBits, 1u);
        const auto slope = [&](glm::ivec3 step) {
            const std::int64_t cross =
                std::int64_t{step[a]} * lattice.D[b] - std::int64_t{step[b]} * lattice.D[a];
            return std::abs(std::ldexp(static_cast<double>(cross), -kStepShift));
        };
        // How far a pixel's G can be from the least that the voxel's own have.
        const double off = width * slope(lattice.U) + height * slope(lattice.V) +
                           2.0 * (tables.D[a] + tables.D[b]) + 2.0 * range;
        if (off >= static_cast<double>(1u << 31)) return false;
        constexpr std::uint32_t kBias = 1u << 31;
        tables.voxelTest.middle[p] = static_cast<std::int32_t>(below ^ kBias);
        tables.voxelTest.end[p] = static_cast<std::int32_t>(range ^ kBias);
        for (unsigned w = 0; w < 8; ++w)
            tables.voxelTest.corner[p][w] =
                (((w >> a & 1u) * tables.D[b] - (w >> b & 1u) * tables.D[a])
                 << lattice.positionBits) -
                below + kBias;
    }
    return true;
}

using WalkMasks = std::array<std::uint8_t, 256>;

constexpr std::array<WalkMasks, 8> kWalkMasks = [] {
    std::array<WalkMasks, 8> all{};
    for (unsigned flip = 0; flip < 8; ++flip)
        for (unsigned mask = 0; mask < 256; ++mask)
            for (unsigned w = 0; w < 8; ++w)
                if ((mask >> (w ^ flip) & 1u) != 0)
                    all[flip][mask] |= static_cast<std::uint8_t>(1u << w);
    return all;
}();

}  // namespace

PacketTree::PacketTree(const OctreeView& view, const IBox& castable, glm::bvec3 mirrored, int level)
    : octree(view), leafLevel(level), box(castable) {
    const int edge = 1 << octree.maxDepth;
    for (int a = 0; a < 3; ++a) {
        if (!mirrored[a]) continue;
        flip[a] = static_cast<std::uint32_t>(edge - 1);
        flipOctant |= 1u << a;
        box.min[a] = edge - castable.max[a];
        box.max[a] = edge - castable.min[a];
    }
    walkMask = kWalkMasks[flipOctant];
}

std::optional<PacketTables> PacketTables::of(const OctreeView& octree, const LatticeView& lattice) {
    PacketTables tables;
    tables.positionBits = lattice.positionBits;
    tables.C = lattice.C + octree.treeFromVoxel * (1 << lattice.positionBits);
    tables.U = lattice.U;
    tables.V = lattice.V;
    const Course course(octree, lattice.D, lattice.positionBits);
    if (!course.castable || lattice.size.x <= 0 || lattice.size.y <= 0) return std::nullopt;
    const glm::bvec3 mirrored = glm::lessThan(lattice.D, glm::ivec3(0));
    tables.tree = PacketTree(octree, course.box, mirrored, 0);
    tables.D = glm::uvec3(glm::abs(lattice.D));

    Int128 normalI[3], normalJ[3];
    Int128 determinant = 0;
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const int c = (a + 2) % 3;
        const auto cross = [&](glm::ivec3 p, glm::ivec3 q) {
            return Int128{p[b]} * q[c] - Int128{p[c]} * q[b];
        };
        normalI[a] = cross(lattice.V, lattice.D);
        normalJ[a] = cross(lattice.D, lattice.U);
        determinant += lattice.U[a] * normalI[a];
    }
    if (determinant == 0) return std::nullopt;
    PixelAxis i = pixelAxis(lattice, tables.C, octree.maxDepth, normalI, determinant);
    PixelAxis j = pixelAxis(lattice, tables.C, octree.maxDepth, normalJ, determinant);
    tables.rootI = i.rootCentre;
    tables.rootJ = j.rootCentre;

    const auto reach = [&](const PixelAxis& axis, int first, int size) {
        return radiusOf(axis, octree.maxDepth, lattice.positionBits) + 2.0 +
               std::max(std::abs(axis.rootCentre - first),
                        std::abs(axis.rootCentre - first - size));
    };
    const double most = std::max(reach(i, lattice.first.x, lattice.size.x),
                                 reach(j, lattice.first.y, lattice.size.y));
    tables.fractionBits = std::min(kMostFractionBits, std::ilogb(kMostFixed / most));
    if (tables.fractionBits < kFewestFractionBits) return std::nullopt;

    // In the walk's mirrored coordinates from here on.
    for (int a = 0; a < 3; ++a) {
        if (!mirrored[a]) continue;
        i.perVoxel[static_cast<std::size_t>(a)] *= -1.0;
        j.perVoxel[static_cast<std::size_t>(a)] *= -1.0;
    }
    for (int k = 0; k < octree.maxDepth; ++k) {
        PacketLevel& level = tables.levels[static_cast<std::size_t>(k)];
        fillBounds(i, k, lattice.positionBits, tables.fractionBits, level.centreI, level.lowI,
                   level.highI);
        fillBounds(j, k, lattice.positionBits, tables.fractionBits, level.centreJ, level.lowJ,
                   level.highJ);
    }
    if (!fillVoxelTest(lattice, tables)) return std::nullopt;
    return tables;
}

}  // namespace voxprite
