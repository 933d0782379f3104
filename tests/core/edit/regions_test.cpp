#include "core/edit/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <functional>

#include "tests/support/positions.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::forEachVoxel;
using test::key;
using test::Positions;
using test::positionsOf;
using test::Random;

// A fill as anyone would write it first: voxel by voxel.
Positions spread(glm::ivec3 seed, Neighbours neighbours,
                 const std::function<bool(glm::ivec3)>& belongs) {
    Positions reached;
    if (!belongs(seed)) return reached;
    std::deque<glm::ivec3> open{seed};
    reached.insert(key(seed));
    while (!open.empty()) {
        const glm::ivec3 v = open.front();
        open.pop_front();
        forEachVoxel({glm::ivec3(-1), glm::ivec3(2)}, [&](glm::ivec3 step) {
            const int axes = std::abs(step.x) + std::abs(step.y) + std::abs(step.z);
            if (axes == 0 || (neighbours == Neighbours::six && axes > 1)) return;
            if (belongs(v + step) && reached.insert(key(v + step)).second) open.push_back(v + step);
        });
    }
    return reached;
}

// Random voxels about the origin, so that fills cross blocks, tiles and negative coordinates, with
// a large uniform block in some.
VoxelGrid scattered(Random& random, double fillRate) {
    VoxelGrid voxels;
    if (random.chance(0.4)) voxels.fill({{-8, 0, 0}, {0, 8, 16}}, 2);
    forEachVoxel({{-12, -12, -12}, {13, 13, 13}}, [&](glm::ivec3 v) {
        if (random.chance(fillRate)) {
            voxels.set(v, static_cast<std::uint8_t>(random.between(1, 2)));
        }
    });
    return voxels;
}

TEST(Regions, AreWhatAFillVoxelByVoxelReaches) {
    Random random(3);
    std::size_t largest = 0;
    for (int round = 0; round < 60; ++round) {
        const VoxelGrid voxels = scattered(random, 0.15 + 0.1 * (round % 5));
        RegionRule rule;
        rule.neighbours = round % 2 == 0 ? Neighbours::six : Neighbours::twentySix;
        rule.sameColour = round % 3 != 0;
        const glm::ivec3 seed = random.voxel(-12, 12);
        const std::uint8_t colour = voxels.get(seed);
        const Positions expected = spread(seed, rule.neighbours, [&](glm::ivec3 v) {
            return rule.sameColour ? voxels.get(v) != 0 && voxels.get(v) == colour
                                   : voxels.get(v) != 0;
        });
        ASSERT_EQ(positionsOf(connectedRegion(voxels, seed, rule).value()), expected);
        largest = std::max(largest, expected.size());
    }
    EXPECT_GT(largest, 5000u);  // else the fills were too easy
}

TEST(Regions, FacesAreExposedCoplanarAndConnected) {
    Random random(4);
    std::size_t largest = 0;
    for (int round = 0; round < 120; ++round) {
        VoxelGrid voxels = scattered(random, 0.02);
        voxels.fill({{-12, -12, -8}, {13, 13, 0}}, 1);
        voxels.fill({{0, -12, -8}, {13, 13, 0}}, 3);
        const int axis = round % 3;
        glm::ivec3 normal(0);
        normal[axis] = round % 2 == 0 ? 1 : -1;
        glm::ivec3 seed = random.voxel(-12, 12);
        if (round % 4 != 0) seed.z = normal.z > 0 ? -1 : -8;
        RegionRule rule;
        rule.neighbours = round % 5 == 0 ? Neighbours::twentySix : Neighbours::six;
        rule.sameColour = round % 7 != 0;
        const std::uint8_t colour = voxels.get(seed);
        const Positions expected = spread(seed, rule.neighbours, [&](glm::ivec3 v) {
            const std::uint8_t value = voxels.get(v);
            return v[axis] == seed[axis] && value != 0 && (!rule.sameColour || value == colour) &&
                   voxels.get(v + normal) == 0;
        });
        ASSERT_EQ(positionsOf(faceRegion(voxels, seed, normal, rule).value()), expected);
        largest = std::max(largest, expected.size());
    }
    EXPECT_GT(largest, 200u);
}

TEST(Regions, PlanesFillUpToWallsAndLimits) {
    Random random(6);
    std::size_t largest = 0;
    for (int round = 0; round < 60; ++round) {
        const VoxelGrid voxels = scattered(random, 0.35);
        const IBox limits = IBox::around(random.voxel(-20, -5), random.voxel(5, 20));
        const int axis = round % 3;
        const glm::ivec3 seed = random.voxel(-15, 15);
        const Positions expected = spread(seed, Neighbours::six, [&](glm::ivec3 v) {
            return v[axis] == seed[axis] && limits.contains(v) && voxels.get(v) == 0;
        });
        ASSERT_EQ(positionsOf(planeRegion(voxels, seed, axis, limits).value()), expected);
        largest = std::max(largest, expected.size());
    }
    EXPECT_GT(largest, 150u);
}

TEST(Regions, TooLargeIsAnError) {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {80, 80, 80}}, 1);
    // Cubes around the region are counted too: it has looked at them.
    EXPECT_TRUE(connectedRegion(voxels, {5, 5, 5}, {}, 12 * 12 * 12));
    const auto region = connectedRegion(voxels, {5, 5, 5}, {}, 999);
    ASSERT_FALSE(region);
    EXPECT_EQ(region.error().message,
              "The region is too large: it spreads over more than 999 blocks of 8 voxels cubed");
    EXPECT_FALSE(faceRegion(voxels, {5, 5, 79}, {0, 0, 1}, {}, 99));
    const IBox everywhere{glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)};
    EXPECT_FALSE(planeRegion(voxels, {-1, 0, 0}, 0, everywhere, 999));
    EXPECT_TRUE(connectedRegion(voxels, {kMaxCoordinate + 9, 0, 0}, {}).value().empty());
    EXPECT_TRUE(connectedRegion(voxels, {-1, 0, 0}, {}).value().empty());
}

TEST(Regions, AWholeSolidCubeOf256) {
    VoxelGrid voxels;
    voxels.fill({{3, 3, 3}, {259, 259, 259}}, 7);
    const VoxelSet region = connectedRegion(voxels, {100, 100, 100}, {}).value();
    EXPECT_EQ(region, VoxelSet(voxels.bounds()));
}

TEST(Regions, RaysVisitEveryCellTheyCross) {
    Random random(8);
    for (int round = 0; round < 300; ++round) {
        const IBox box = IBox::around(random.voxel(-9, 9), random.voxel(-9, 9));
        const glm::dvec3 origin(random.unit() * 40 - 20, random.unit() * 40 - 20,
                                random.unit() * 40 - 20);
        const glm::dvec3 aim(random.unit() * 18 - 9, random.unit() * 18 - 9,
                             random.unit() * 18 - 9);
        const std::vector<glm::ivec3> cells = voxelsAlongRay(origin, aim - origin, box);
        // Each cell shares a face with the next, and none stands twice.
        for (std::size_t i = 1; i < cells.size(); ++i) {
            const glm::ivec3 step = glm::abs(cells[i] - cells[i - 1]);
            ASSERT_EQ(step.x + step.y + step.z, 1);
        }
        const Positions visited = positionsOf(cells);
        ASSERT_EQ(visited.size(), cells.size());
        // Exactly the cells that the ray crosses, by intersecting it with each; those that it
        // merely grazes may go either way.
        forEachVoxel(box, [&](glm::ivec3 v) {
            double enter = 0;
            double leave = INFINITY;
            for (int axis = 0; axis < 3; ++axis) {
                const double a = (v[axis] - origin[axis]) / (aim - origin)[axis];
                const double b = (v[axis] + 1 - origin[axis]) / (aim - origin)[axis];
                enter = std::max(enter, std::min(a, b));
                leave = std::min(leave, std::max(a, b));
            }
            if (std::abs(leave - enter) < 1e-9) return;
            ASSERT_EQ(visited.contains(key(v)), enter < leave);
        });
    }
}

TEST(Regions, RaysAlongAnAxisAndRaysThatAreNone) {
    const IBox box{{0, 0, 0}, {4, 4, 4}};
    const std::vector<glm::ivec3> row{{0, 1, 2}, {1, 1, 2}, {2, 1, 2}, {3, 1, 2}};
    EXPECT_EQ(voxelsAlongRay({-5, 1.5, 2.5}, {1, 0, 0}, box), row);
    EXPECT_EQ(voxelsAlongRay({-5, 1.0, 2.0}, {2, 0, 0}, box), row);
    EXPECT_EQ(voxelsAlongRay({9, 1.5, 2.5}, {-1, 0, 0}, box),
              std::vector<glm::ivec3>(row.rbegin(), row.rend()));
    EXPECT_TRUE(voxelsAlongRay({9, 1.5, 2.5}, {1, 0, 0}, box).empty());
    EXPECT_TRUE(voxelsAlongRay({-5, 4.0, 2.5}, {1, 0, 0}, box).empty());
    EXPECT_TRUE(voxelsAlongRay({1, 1, 1}, {0, 0, 0}, box).empty());
    EXPECT_TRUE(voxelsAlongRay({NAN, 1, 1}, {1, 0, 0}, box).empty());
    EXPECT_TRUE(voxelsAlongRay({1, 1, 1}, {INFINITY, 0, 0}, box).empty());
    EXPECT_TRUE(voxelsAlongRay({1, 1, 1}, {1, 0, 0}, IBox{}).empty());
}

TEST(Regions, ByColour) {
    Random random(9);
    const VoxelGrid voxels = scattered(random, 0.3);
    for (const int colour : {0, 1, 2, 3}) {
        Positions expected;
        voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            if (value == colour) expected.insert(key(v));
        });
        EXPECT_EQ(positionsOf(voxelsOfColour(voxels, static_cast<std::uint8_t>(colour))), expected);
    }
}

}  // namespace
}  // namespace voxprite
