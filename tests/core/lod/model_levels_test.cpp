#include "core/lod/model_levels.h"

#include <gtest/gtest.h>

#include "core/svo/bake.h"
#include "core/svo/coarsen.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

TEST(ModelLevels, CoarserOctreesAreThoseOfTheModelItself) {
    const Octree model = must(bake(figure()));
    const ModelLevels levels = must(buildModelLevels(model));
    EXPECT_EQ(levels.origin, model.origin);
    ASSERT_EQ(levels.coarse.size(), 3u);
    for (int left = 1; left <= 3; ++left) {
        EXPECT_EQ(levels.coarse[static_cast<std::size_t>(left - 1)], must(coarsen(model, left)));
    }
    EXPECT_FALSE(levels.clusters.indices.empty());
}

TEST(ModelLevels, FourCellsAreTheLeastThatIsWorthDrawing) {
    const auto edge = [](int voxels) {
        VoxelGrid grid;
        for (int x = 0; x < voxels; ++x) grid.set({x, 0, 0}, 1);
        return must(buildModelLevels(must(bake(grid)))).coarse.size();
    };
    EXPECT_EQ(edge(1), 0u);
    EXPECT_EQ(edge(7), 0u);
    EXPECT_EQ(edge(8), 1u);
    EXPECT_EQ(edge(31), 2u);
    EXPECT_EQ(edge(500), 3u);
}

TEST(ModelLevels, AnEmptyModelHasNone) {
    const ModelLevels levels = must(buildModelLevels(Octree{}));
    EXPECT_TRUE(levels.coarse.empty());
    EXPECT_TRUE(levels.clusters.indices.empty());
}

TEST(ModelLevels, WhatIsTooDeepForAMeshStillGetsCoarser) {
    VoxelGrid grid;
    grid.set({0, 0, 0}, 1);
    grid.set({40'000, 0, 0}, 2);
    const ModelLevels levels = must(buildModelLevels(must(bake(grid))));
    EXPECT_EQ(levels.coarse.size(), 3u);
    EXPECT_TRUE(levels.clusters.indices.empty());
}

}  // namespace
}  // namespace voxprite::test
