// The octree ray cast: its limits, its guard, what is no ray, and rays in the world.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/svo/coarsen.h"
#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/raycast_rays.h"

namespace voxprite::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two voxels on a line in a box of 8 cubed.
DenseModel pairOfVoxels() {
    DenseModel model("pair", {8, 8, 8});
    model[{2, 3, 4}] = 10;
    model[{6, 3, 4}] = 20;
    return model;
}

TEST(RaycastDepth, ANodeAtTheLimitThatHoldsAnythingIsOneCube) {
    // In the root of 8 cubed (depth 3) the nodes of depth 1 are 4 cubed.
    DenseModel model("few", {8, 8, 8});
    model[{1, 3, 2}] = 30;
    model[{2, 1, 1}] = 40;
    model[{7, 7, 7}] = 50;
    const NaiveOctree tree(model);
    const Ray ray{{3.75, -1, 0.25}, {0, 1, 0}};  // past the voxels, through their node
    EXPECT_FALSE(raycast(tree.view(), ray).hit);
    EXPECT_FALSE(raycast(tree.view(), ray, {.maxDepth = 3}).hit);
    const RaycastHit node = raycast(tree.view(), ray, {.maxDepth = 1});
    ASSERT_TRUE(node.hit);
    EXPECT_EQ(node.voxel, glm::ivec3(0));
    EXPECT_EQ(node.point, glm::dvec3(3.75, 0.0, 0.25));
    EXPECT_DOUBLE_EQ(node.t, 1.0);
    // Of the node's two voxels, (2,1,1) lies in octant 1 and (1,3,2) in octant 6.
    EXPECT_EQ(node.value, 40);
    EXPECT_EQ(raycast(tree.view(), {{9, 5, 5}, {-1, 0, 0}}, {.maxDepth = 1}).value, 50);
    EXPECT_FALSE(raycast(tree.view(), {{9, 5, 3}, {-1, 0, 0}}, {.maxDepth = 1}).hit);
}

TEST(RaycastDepth, ZeroIsTheRootCube) {
    DenseModel model("corner", {5, 6, 7});
    model[{4, 5, 6}] = 77;
    const NaiveOctree tree(model);
    // The whole root counts, also where the model's box ends before it: solid or not as it is.
    const RaycastHit hit = raycast(tree.view(), {{7.5, 7.5, 20}, {0, 0, -1}}, {.maxDepth = 0});
    ASSERT_TRUE(hit.hit);
    EXPECT_EQ(hit.value, 77);
    EXPECT_EQ(hit.voxel, glm::ivec3(0));
    EXPECT_DOUBLE_EQ(hit.t, 12.0);
    EXPECT_EQ(hit.normal, glm::dvec3(0, 0, 1));
    EXPECT_TRUE(raycast(tree.view(), {{7.5, 7.5, 20}, {0, 0, -1}}, {.maxDepth = -5}).hit);
    EXPECT_FALSE(raycast(Octree{}.view(), {{0.5, 0.5, 20}, {0, 0, -1}}, {.maxDepth = 0}).hit);
    // A root that is one solid leaf is the same at every depth.
    const NaiveOctree full(solid({4, 4, 4}, 6));
    for (int depth = 0; depth <= 3; ++depth)
        EXPECT_DOUBLE_EQ(raycast(full.view(), {{-1, 1.5, 1.5}, {1, 0, 0}}, {.maxDepth = depth}).t,
                         1.0);
}

TEST(RaycastDepth, FewerLevelsCostFewerNodes) {
    const NaiveOctree tree(shell(64));
    Rays rays(1);
    std::vector<Ray> all;
    for (int n = 0; n < 2000; ++n) all.push_back(rays.common({64, 64, 64}, 2.0));
    std::uint64_t before = 0;
    for (int depth = 0; depth <= 6; ++depth) {
        RaycastCounters counters;
        int hits = 0;
        for (const Ray& ray : all)
            hits += raycast(tree.view(), ray, {.maxDepth = depth}, &counters).hit ? 1 : 0;
        EXPECT_GT(hits, 1000);
        EXPECT_GT(counters.iterations + counters.nodes, before) << depth;
        before = counters.iterations + counters.nodes;
    }
}

// The cubes at a limit are the voxels of the octree made that much coarser, wherever a ray goes;
// its colours follow another rule.
TEST(RaycastDepth, TheLimitsCubesAreTheCoarserOctrees) {
    Rays rays(6);
    for (const DenseModel& model : {randomVoxels({40, 21, 33}, 0.01, 8), figure(1), shell(32)}) {
        const NaiveOctree tree(model);
        for (int levels = 1; levels < tree.octree.maxDepth; ++levels) {
            const Result<Octree> coarse = coarsen(tree.octree, levels);
            ASSERT_TRUE(coarse);
            const int edge = 1 << levels;
            int hits = 0;
            for (int n = 0; n < 3000; ++n) {
                const Ray ray =
                    n % 2 == 0 ? rays.common(model.size, 1.0) : rays.special(model.size);
                const Ray small{ray.origin / double(edge), ray.direction};
                const int depth = tree.octree.maxDepth - levels;
                const RaycastHit got = raycast(tree.view(), ray, {.maxDepth = depth});
                const RaycastHit want = raycast(coarse->view(), small);
                ASSERT_EQ(got.hit, want.hit) << model.name << ' ' << describe(ray);
                if (!got.hit) continue;
                ++hits;
                ASSERT_EQ(got.voxel, want.voxel * edge) << model.name << ' ' << describe(ray);
                ASSERT_EQ(got.normal, want.normal) << model.name << ' ' << describe(ray);
                ASSERT_NEAR(got.t, want.t * edge, 1e-9 * (1.0 + got.t));
            }
            EXPECT_GT(hits, 500);
        }
    }
}

TEST(RaycastLimits, HitsBeyondTheGreatestTDoNotCount) {
    const NaiveOctree tree(pairOfVoxels());
    const Ray ray{{-10, 3.5, 4.5}, {3, 0, 0}};
    EXPECT_TRUE(raycast(tree.view(), ray, {.greatestT = 12.0}).hit);
    EXPECT_FALSE(raycast(tree.view(), ray, {.greatestT = 11.999}).hit);
    EXPECT_FALSE(raycast(tree.view(), ray, {.greatestT = -1.0}).hit);
    EXPECT_FALSE(raycast(tree.view(), ray, {.greatestT = std::nan("")}).hit);
    EXPECT_TRUE(raycast(tree.view(), ray, {.greatestT = kInfinity}).hit);
    EXPECT_TRUE(raycast(tree.view(), {{2.5, 3.5, 4.5}, {0, 1, 0}}, {.greatestT = 0.0}).hit);
    // And the walk ends there: of a long way through nothing a short part costs little.
    DenseModel noise = randomVoxels({64, 64, 64}, 0.02, 3);
    for (int x = 0; x < 64; ++x) noise[{x, 20, 20}] = 0;
    RaycastCounters whole;
    RaycastCounters part;
    const Ray through{{0.5, 20.5, 20.5}, {1, 0, 0}};
    const NaiveOctree forest(noise);
    EXPECT_FALSE(raycast(forest.view(), through, {}, &whole).hit);
    EXPECT_FALSE(raycast(forest.view(), through, {.greatestT = 4.0}, &part).hit);
    EXPECT_LT(part.iterations * 3, whole.iterations);
}

TEST(RaycastLimits, AnyGreatestTGivesTheSameHitOrNone) {
    const DenseModel model = randomVoxels({20, 30, 25}, 0.02, 5);
    const NaiveOctree tree(model);
    Rays rays(3);
    int cut = 0;
    for (int n = 0; n < 20000; ++n) {
        const Ray ray = n % 2 == 0 ? rays.common(model.size, 1.0) : rays.grazing(model.size);
        const RaycastHit free = raycast(tree.view(), ray);
        const double most = rays.among(0, 40) * rays.among(0, 10) * 0.1;
        const RaycastHit held = raycast(tree.view(), ray, {.greatestT = most});
        ASSERT_EQ(held.hit, free.hit && free.t <= most) << describe(ray);
        if (held.hit) {
            ASSERT_EQ(held.voxel, free.voxel);
        }
        cut += free.hit && !held.hit ? 1 : 0;
    }
    EXPECT_GT(cut, 1000);
}

TEST(RaycastGuard, ReportsAndIsNeverReachedOtherwise) {
    const NaiveOctree tree(randomVoxels({64, 64, 64}, 0.02, 7));
    Rays rays(4);
    RaycastCounters free;
    RaycastCounters seeds;
    RaycastCounters tight;
    int lost = 0;
    for (int n = 0; n < 20000; ++n) {
        const Ray ray = n % 2 == 0 ? rays.common({64, 64, 64}, 1.0) : rays.grazing({64, 64, 64});
        const bool hit = raycast(tree.view(), ray, {}, &free).hit;
        // The seed's 1,000 are more than the 3 * 64 planes of the grid.
        EXPECT_EQ(raycast(tree.view(), ray, {.mostIterations = 1000}, &seeds).hit, hit);
        const bool soon = raycast(tree.view(), ray, {.mostIterations = 2}, &tight).hit;
        EXPECT_FALSE(soon && !hit);
        lost += hit && !soon ? 1 : 0;
    }
    EXPECT_EQ(free.guardReached, 0u);
    EXPECT_EQ(seeds.guardReached, 0u);
    EXPECT_GE(tight.guardReached, static_cast<std::uint64_t>(lost));
    EXPECT_GT(lost, 1000);
    EXPECT_LE(free.iterations, free.rays * (3 * 64 + 1));
}

TEST(RaycastInput, WhatIsNoRayHitsNothing) {
    const NaiveOctree tree(solid({4, 4, 4}, 1));
    for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
        for (int a = 0; a < 3; ++a) {
            glm::dvec3 broken(1.0);
            broken[a] = bad;
            EXPECT_FALSE(raycast(tree.view(), {broken, {1, 1, 1}}).hit);
            EXPECT_FALSE(raycast(tree.view(), {{1, 1, 1}, broken}).hit);
        }
    }
    EXPECT_FALSE(raycast(tree.view(), {{1, 1, 1}, {0, 0, 0}}).hit);
    EXPECT_FALSE(raycast(Octree{}.view(), {{1, 1, 1}, {1, 0, 0}}).hit);
}

TEST(RaycastInput, ExtremesAreProperRays) {
    const NaiveOctree tree(solid({4, 4, 4}, 1));
    EXPECT_TRUE(raycast(tree.view(), {{1e300, 2, 2}, {-1e300, 0, 0}}).hit);
    EXPECT_FALSE(raycast(tree.view(), {{1e300, 1e300, 1e300}, {-1, -0.5, -1}}).hit);
    EXPECT_FALSE(raycast(tree.view(), {{1e308, 0, 0}, {-1e-308, 1, 1}}).hit);
    EXPECT_TRUE(raycast(tree.view(), {{-1, 2, 2}, {1e-310, 0, 0}}).hit);
    EXPECT_TRUE(raycast(tree.view(), {{-1, 2, 2}, {1, 1e-300, -1e-300}}).hit);
    const double most = std::numeric_limits<double>::max();
    EXPECT_TRUE(raycast(tree.view(), {{2, 2, -1}, {0, most * 1e-9, most}}).hit);
    const RaycastHit far = raycast(tree.view(), {{-1e9, 2, 2}, {1, 0, 0}});
    EXPECT_DOUBLE_EQ(far.t, 1e9);
    EXPECT_EQ(far.point, glm::dvec3(0, 2, 2));
}

// 90 degrees about the voxels' Z, from voxel axes to a Y-up world.
VoxelPlacement turnedPlacement() {
    VoxelPlacement placement;
    placement.worldFromVoxelAxes =
        glm::dmat3(glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0));
    placement.anchorVoxels = {2, 2, 0};
    placement.anchorMetres = {100, 50, -30};
    placement.metresPerVoxel = 0.25;
    return placement;
}

TEST(RaycastWorld, MetresAndAxesOfTheWorld) {
    const NaiveOctree tree(solid({4, 4, 4}, 8));
    const VoxelPlacement placement = turnedPlacement();
    // From above: the top of the model stands one metre over its anchor.
    const RaycastHit above = raycast(tree.view(), placement, {{100.1, 53, -30.1}, {0, -7, 0}});
    ASSERT_TRUE(above.hit);
    EXPECT_DOUBLE_EQ(above.t, 2.0);
    EXPECT_EQ(above.point, glm::dvec3(100.1, 51, -30.1));
    EXPECT_EQ(above.normal, glm::dvec3(0, 1, 0));
    EXPECT_EQ(above.axis, 2);
    // The world's -Z is the voxels' X.
    const RaycastHit front = raycast(tree.view(), placement, {{100, 50.5, -40}, {0, 0, 1}});
    ASSERT_TRUE(front.hit);
    EXPECT_DOUBLE_EQ(front.t, 9.5);
    EXPECT_EQ(front.normal, glm::dvec3(0, 0, -1));
    EXPECT_EQ(front.voxel.x, 3);
    // Limits are metres, too.
    EXPECT_FALSE(
        raycast(tree.view(), placement, {{100.1, 53, -30.1}, {0, -7, 0}}, {.greatestT = 1.99}).hit);
}

TEST(RaycastWorld, AgreesWithTheVoxelsOwnSpace) {
    const DenseModel model = figure(1);
    const NaiveOctree tree(model);
    const VoxelPlacement placement = turnedPlacement();
    Rays rays(5);
    for (int n = 0; n < 3000; ++n) {
        const Ray inVoxels = rays.common(model.size, 2.0);
        const Ray inWorld{placement.anchorMetres + placement.worldFromVoxelAxes *
                                                       (inVoxels.origin - placement.anchorVoxels) *
                                                       placement.metresPerVoxel,
                          placement.worldFromVoxelAxes * inVoxels.direction};
        const Ray back = voxelRay(placement, inWorld);
        ASSERT_LT(glm::length(back.origin - inVoxels.origin), 1e-9);
        const RaycastHit want = raycast(tree.view(), back);
        const RaycastHit got = raycast(tree.view(), placement, inWorld);
        ASSERT_EQ(got.hit, want.hit);
        if (!got.hit) continue;
        ASSERT_EQ(got.voxel, want.voxel);
        ASSERT_EQ(got.value, want.value);
        ASSERT_DOUBLE_EQ(got.t, want.t * placement.metresPerVoxel);
        ASSERT_EQ(got.normal, placement.worldFromVoxelAxes * want.normal);
        const glm::dvec3 along =
            inWorld.origin + glm::normalize(inWorld.direction) * got.t - got.point;
        ASSERT_LT(glm::length(along), 2.0 * raySlack(tree.view()) * placement.metresPerVoxel);
    }
}

}  // namespace
}  // namespace voxprite::test
