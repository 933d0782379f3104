#include "core/model/voxel_morphology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::mapOf;
using test::Random;
using test::VoxelMap;

constexpr IBox kAround{{-6, -6, -6}, {30, 30, 30}};

template <class Visit>
void forEachVoxel(const IBox& box, const Visit& visit) {
    for (int x = box.min.x; x < box.max.x; ++x) {
        for (int y = box.min.y; y < box.max.y; ++y) {
            for (int z = box.min.z; z < box.max.z; ++z) visit(glm::ivec3(x, y, z));
        }
    }
}

std::array<glm::ivec3, 6> faceNeighbours(glm::ivec3 v) {
    return {v + glm::ivec3(1, 0, 0),  v + glm::ivec3(-1, 0, 0), v + glm::ivec3(0, 1, 0),
            v + glm::ivec3(0, -1, 0), v + glm::ivec3(0, 0, 1),  v + glm::ivec3(0, 0, -1)};
}

// The most frequent of the solid values, of several the lowest; 0 when there is none.
std::uint8_t mostFrequent(std::span<const std::uint8_t> values) {
    std::array<int, 256> counts{};
    for (const std::uint8_t value : values) ++counts[value];
    std::uint8_t best = 0;
    for (int i = 1; i < 256; ++i) {
        if (counts[static_cast<std::size_t>(i)] > (best == 0 ? 0 : counts[best])) {
            best = static_cast<std::uint8_t>(i);
        }
    }
    return best;
}

VoxelGrid dilatedOnce(const VoxelGrid& voxels) {
    VoxelGrid result = voxels;
    forEachVoxel(kAround, [&](glm::ivec3 v) {
        if (voxels.get(v) != 0) return;
        std::array<std::uint8_t, 6> values{};
        for (std::size_t i = 0; i < 6; ++i) values[i] = voxels.get(faceNeighbours(v)[i]);
        result.set(v, mostFrequent(values));
    });
    return result;
}

VoxelGrid erodedOnce(const VoxelGrid& voxels) {
    VoxelGrid result;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        for (const glm::ivec3 n : faceNeighbours(v)) {
            if (voxels.get(n) == 0) return;
        }
        result.set(v, value);
    });
    return result;
}

VoxelGrid smoothedOnce(const VoxelGrid& voxels) {
    VoxelGrid result;
    forEachVoxel(kAround, [&](glm::ivec3 v) {
        std::vector<std::uint8_t> values;
        forEachVoxel({v - 1, v + 2}, [&](glm::ivec3 n) { values.push_back(voxels.get(n)); });
        const auto solid = std::count_if(values.begin(), values.end(), [](auto x) { return x; });
        if (solid < 14) return;
        result.set(v, voxels.get(v) != 0 ? voxels.get(v) : mostFrequent(values));
    });
    return result;
}

// Lumps of several forms: noise, dense noise, tiles, single voxels.
VoxelGrid lumps(Random& random, int round) {
    VoxelGrid voxels = test::randomVoxels(random.next(), {20, 18, 22}, 0.05 + 0.2 * (round % 5), 4);
    if (round % 2 == 0) voxels.fill({{0, 8, 0}, {16, 16, 16}}, 5);
    if (round % 3 == 0) voxels.fill(IBox::around(random.voxel(0, 20), random.voxel(0, 20)), 6);
    return voxels;
}

TEST(Morphology, DilatesLayerByLayer) {
    Random random(81);
    for (int round = 0; round < 6; ++round) {
        const VoxelGrid voxels = lumps(random, round);
        VoxelGrid expected = voxels;
        for (int layers = 1; layers <= 3; ++layers) {
            expected = dilatedOnce(expected);
            ASSERT_EQ(mapOf(dilated(voxels, layers).value()), mapOf(expected));
        }
    }
}

TEST(Morphology, ErodesAndHollows) {
    Random random(82);
    for (int round = 0; round < 6; ++round) {
        const VoxelGrid voxels = lumps(random, round);
        VoxelGrid expected = voxels;
        for (int layers = 1; layers <= 3; ++layers) {
            expected = erodedOnce(expected);
            ASSERT_EQ(mapOf(eroded(voxels, layers).value()), mapOf(expected));
            VoxelMap wall = mapOf(voxels);
            for (const auto& [position, value] : mapOf(expected)) wall.erase(position);
            ASSERT_EQ(mapOf(hollowed(voxels, layers).value()), wall);
        }
    }
}

TEST(Morphology, SmoothsByMajority) {
    Random random(83);
    for (int round = 0; round < 6; ++round) {
        const VoxelGrid voxels = lumps(random, round);
        const VoxelGrid once = smoothedOnce(voxels);
        ASSERT_EQ(mapOf(smoothed(voxels, 1).value()), mapOf(once));
        ASSERT_EQ(mapOf(smoothed(voxels, 2).value()), mapOf(smoothedOnce(once)));
    }
}

TEST(Morphology, ASingleVoxelGrowsToAnOctahedron) {
    VoxelGrid voxels;
    voxels.set({7, 7, 7}, 9);
    const VoxelGrid grown = dilated(voxels, 5).value();
    grown.forEachSolid([](glm::ivec3 v, std::uint8_t value) {
        const glm::ivec3 d = glm::abs(v - 7);
        EXPECT_LE(d.x + d.y + d.z, 5);
        EXPECT_EQ(value, 9);
    });
    EXPECT_EQ(grown.solidCount(), 231u);  // the octahedral number of 11 steps
    EXPECT_EQ(eroded(grown, 5).value(), voxels);
}

TEST(Morphology, ALargeSolidCubeKeepsItsFaces) {
    const VoxelGrid cube = test::solidBox({150, 150, 150}, 3);
    VoxelGrid inner;
    inner.fill({{4, 4, 4}, {146, 146, 146}}, 3);
    EXPECT_EQ(eroded(cube, 4).value(), inner);
    VoxelGrid wall = cube;
    wall.fill({{4, 4, 4}, {146, 146, 146}}, 0);
    EXPECT_EQ(hollowed(cube, 4).value(), wall);
    // Smoothing takes the twelve edges (of 150 voxels, corners shared) and nothing else.
    EXPECT_EQ(smoothed(cube, 1).value().solidCount(), 150u * 150 * 150 - (12u * 148 + 8));
}

TEST(Morphology, LimitsAreErrors) {
    const VoxelGrid voxels = test::solidBox({3, 3, 3});
    for (const int layers : {0, -1, kMaxMorphologyLayers + 1}) {
        EXPECT_FALSE(dilated(voxels, layers));
        EXPECT_FALSE(eroded(voxels, layers));
        EXPECT_FALSE(hollowed(voxels, layers));
        EXPECT_FALSE(smoothed(voxels, layers));
    }
    EXPECT_EQ(hollowed(voxels, 0).error().message, "wall is 0; it must be between 1 and 64");
    VoxelGrid atTheEnd;
    atTheEnd.set({kMaxCoordinate, 0, 0}, 1);
    EXPECT_FALSE(dilated(atTheEnd, 1));
    EXPECT_TRUE(eroded(atTheEnd, 1).value().empty());
    VoxelGrid huge;
    huge.fill({{0, 0, 0}, {4096, 4096, 4096}}, 1);
    EXPECT_FALSE(eroded(huge, 1));
    EXPECT_FALSE(smoothed(huge, 1));
    EXPECT_TRUE(dilated(VoxelGrid(), 1).value().empty());
    EXPECT_TRUE(smoothed(VoxelGrid(), 1).value().empty());
}

}  // namespace
}  // namespace voxprite
