#include "core/svo/coarsen.h"

#include <gtest/gtest.h>

#include <map>

#include "core/svo/bake.h"
#include "core/svo/live_octree.h"
#include "core/svo/validate.h"
#include "tests/core/svo/reference_octree.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

int floorDiv(int value, int divisor) {
    return (value >= 0 ? value : value - divisor + 1) / divisor;
}

// The rule voxel by voxel, from the grid.
VoxelGrid naive(const VoxelGrid& voxels, int levels) {
    struct Votes {
        std::map<int, int> exposed;
        std::map<int, int> all;
    };
    const int edge = 1 << levels;
    std::map<std::tuple<int, int, int>, Votes> cells;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t material) {
        Votes& votes = cells[{floorDiv(v.x, edge), floorDiv(v.y, edge), floorDiv(v.z, edge)}];
        ++votes.all[material];
        int openFaces = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1}) {
                glm::ivec3 beside = v;
                beside[axis] += side;
                openFaces += voxels.get(beside) == 0 ? 1 : 0;
            }
        }
        if (openFaces > 0) votes.exposed[material] += openFaces;
    });
    VoxelGrid coarse;
    for (const auto& [cell, votes] : cells) {
        const std::map<int, int>& counted = votes.exposed.empty() ? votes.all : votes.exposed;
        int best = 0;
        int most = 0;
        for (const auto& [material, count] : counted) {  // ascending: the lowest wins a tie
            if (count > most) std::tie(best, most) = std::pair(material, count);
        }
        coarse.set({std::get<0>(cell), std::get<1>(cell), std::get<2>(cell)},
                   static_cast<std::uint8_t>(best));
    }
    return coarse;
}

Octree baked(const VoxelGrid& voxels) {
    return must(bake(voxels));
}

TEST(Coarsen, EqualsTheRuleVoxelByVoxel) {
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) {
        const glm::ivec3 centre = test::randomIn(random, glm::ivec3(-90), glm::ivec3(90));
        const VoxelGrid voxels = test::randomModel(random, centre, 1 + i % 41);
        if (voxels.empty()) continue;
        for (int levels = 1; levels <= 6; ++levels) {
            const Octree coarse = must(coarsen(baked(voxels), levels));
            const Status valid = validateCanonical(coarse);
            ASSERT_TRUE(valid) << valid.error().describe();
            ASSERT_EQ(toVoxels(coarse), naive(voxels, levels)) << "model " << i << " " << levels;
            // The cells that the bounds touch, and no more: what bake would make of them.
            EXPECT_EQ(coarse, must(bake(naive(voxels, levels))));
        }
    }
}

TEST(Coarsen, ByNoLevelIsTheSame) {
    std::mt19937 random(12);
    for (int i = 0; i < 20; ++i) {
        const VoxelGrid voxels = test::randomModel(random, {5, -3, 8}, 30);
        const Octree octree = baked(voxels);
        EXPECT_EQ(must(coarsen(octree, 0)), octree);
    }
    EXPECT_EQ(must(coarsen(Octree{}, 0)), Octree{});
    EXPECT_EQ(must(coarsen(Octree{}, 3)), Octree{});
}

TEST(Coarsen, InStepsTheShapeIsThatOfOneGo) {
    std::mt19937 random(13);
    for (int i = 0; i < 40; ++i) {
        const VoxelGrid voxels = test::randomModel(random, {7, 9, -31}, 3 + i);
        if (voxels.empty()) continue;
        const Octree octree = baked(voxels);
        const Octree once = must(coarsen(octree, 3));
        const Octree steps = must(coarsen(must(coarsen(octree, 1)), 2));
        EXPECT_EQ(steps.size, once.size);
        EXPECT_EQ(steps.origin, once.origin);
        EXPECT_EQ(solidCount(steps.view()), solidCount(once.view()));
        for (const auto& [place, material] : test::mapOf(toVoxels(steps))) {
            const auto [x, y, z] = place;
            EXPECT_NE(materialAt(once.view(), glm::ivec3(x, y, z) - once.origin), 0);
        }
    }
}

TEST(Coarsen, OneMaterialInStepsIsExactlyOneGo) {
    const Octree ball = baked(test::solidBox({37, 22, 51}, 9));
    EXPECT_EQ(must(coarsen(must(coarsen(ball, 2)), 2)), must(coarsen(ball, 4)));
}

TEST(Coarsen, OneVoxelFillsItsCell) {
    for (const int at : {-9, -8, -1, 0, 1, 7, 8}) {
        VoxelGrid voxels;
        voxels.set({at, 3, 0}, 77);
        const Octree coarse = must(coarsen(baked(voxels), 3));
        EXPECT_EQ(coarse.size, glm::ivec3(1));
        EXPECT_EQ(coarse.origin, glm::ivec3(floorDiv(at, 8), 0, 0));
        EXPECT_EQ(materialAt(coarse.view(), glm::ivec3(0)), 77);
    }
}

TEST(Coarsen, TheColourIsThatOfTheSurface) {
    // A crate of 16 cubed: wood outside, filled with sand.
    VoxelGrid crate;
    crate.fill({glm::ivec3(0), glm::ivec3(16)}, 3);
    crate.fill({glm::ivec3(1), glm::ivec3(15)}, 200);
    for (const int levels : {3, 4}) {
        test::VoxelMap cells = test::mapOf(toVoxels(must(coarsen(baked(crate), levels))));
        EXPECT_EQ(cells.size(), levels == 3 ? 8u : 1u);
        for (const auto& [place, material] : cells) EXPECT_EQ(material, 3);
    }
    // A cell without surface shows the most of what it holds.
    const Octree middle = must(coarsen(baked(crate), 1));
    EXPECT_EQ(materialAt(middle.view(), {3, 3, 3}), 200);
    EXPECT_EQ(materialAt(middle.view(), {0, 3, 3}), 3);
}

TEST(Coarsen, TheLowestIndexWinsATie) {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 9);
    voxels.set({1, 1, 1}, 4);
    voxels.set({1, 0, 1}, 4);
    voxels.set({0, 1, 0}, 9);
    EXPECT_EQ(must(coarsen(baked(voxels), 1)).nodes, std::vector<std::uint32_t>{0x4000'0000});
    EXPECT_EQ(must(coarsen(baked(voxels), 1)).payloads, std::vector<std::uint64_t>{4});
}

TEST(Coarsen, DrawingAtOneEndLeavesTheOtherAsItIs) {
    VoxelGrid voxels = test::figure();
    const Octree before = must(coarsen(baked(voxels), 2));
    voxels.set({-5, -3, -1}, 8);  // moves the corner by an odd number
    const Octree after = must(coarsen(baked(voxels), 2));
    test::VoxelMap cells = test::mapOf(toVoxels(after));
    EXPECT_EQ(cells.erase({-2, -1, -1}), 1u);
    EXPECT_EQ(cells, test::mapOf(toVoxels(before)));
}

TEST(Coarsen, ALiveOctreeIsAsGoodAsABakedOne) {
    std::mt19937 random(14);
    VoxelGrid voxels;
    LiveOctree live;
    for (int i = 0; i < 300; ++i) {
        const glm::ivec3 v = test::randomIn(random, glm::ivec3(-20), glm::ivec3(30));
        const auto material = static_cast<std::uint8_t>(random() % 3);
        voxels.set(v, material);
        const LiveOctree::Edit edit{v, material};
        ASSERT_TRUE(live.apply({&edit, 1}));
        if (i % 25 != 24) continue;
        const IBox bounds = voxels.bounds();
        EXPECT_EQ(must(coarsen(live.view(bounds), bounds.min, 2)), must(coarsen(baked(voxels), 2)));
    }
}

TEST(Coarsen, BoundsWiderThanTheVoxelsStay) {
    // A frame of an animation is baked with the bounds of all.
    const IBox bounds{{-3, 0, 5}, {14, 9, 20}};
    VoxelGrid voxels;
    voxels.set({0, 0, 8}, 5);
    const Octree coarse = must(coarsen(must(bake(voxels, bounds)), 2));
    EXPECT_EQ(coarse.origin, glm::ivec3(-1, 0, 1));
    EXPECT_EQ(coarse.size, glm::ivec3(5, 3, 4));
    EXPECT_EQ(solidCount(coarse.view()), 1u);
    EXPECT_EQ(materialAt(coarse.view(), {1, 0, 1}), 5);
}

TEST(Coarsen, OtherLevelsAreRefused) {
    const Octree octree = baked(test::figure());
    EXPECT_FALSE(coarsen(octree, -1));
    EXPECT_FALSE(coarsen(octree, 17));
    const Octree all = must(coarsen(octree, 16));
    EXPECT_EQ(all.size, glm::ivec3(1));
}

}  // namespace
}  // namespace voxprite
