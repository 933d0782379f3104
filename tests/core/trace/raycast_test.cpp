// The octree ray cast scenario by scenario, with answers worked out by hand.
#include "core/trace/raycast.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/exact_caster.h"
#include "tests/core/trace/raycast_rays.h"

namespace voxprite::test {
namespace {

// Two voxels on a line in a box of 8 cubed.
DenseModel pairOfVoxels() {
    DenseModel model("pair", {8, 8, 8});
    model[{2, 3, 4}] = 10;
    model[{6, 3, 4}] = 20;
    return model;
}

// One voxel far inside an empty root of that many levels.
NaiveOctree needle(int depth, glm::ivec3 voxel) {
    NaiveOctree tree(DenseModel("root", {1, 1, 1}));
    Octree& octree = tree.octree;
    octree.maxDepth = depth;
    octree.size = glm::ivec3(1 << depth);
    octree.nodes.clear();
    octree.payloads.clear();
    for (int bit = depth - 1; bit > 0; --bit) {
        const auto next = static_cast<std::uint32_t>(octree.nodes.size() + 1);
        octree.nodes.push_back(node::internal(next, 1u << octantOf(voxel, bit)));
    }
    octree.nodes.push_back(node::brick(0));
    octree.payloads.push_back(std::uint64_t{9} << (8 * octantOf(voxel, 0)));
    return tree;
}

TEST(RaycastHits, TheFirstSolidVoxelEndsTheRay) {
    const NaiveOctree tree(pairOfVoxels());
    const RaycastHit hit = raycast(tree.view(), {{-10, 3.5, 4.25}, {2, 0, 0}});
    ASSERT_TRUE(hit.hit);
    EXPECT_DOUBLE_EQ(hit.t, 12.0);
    EXPECT_EQ(hit.point, glm::dvec3(2.0, 3.5, 4.25));
    EXPECT_EQ(hit.normal, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(hit.voxel, glm::ivec3(2, 3, 4));
    EXPECT_EQ(hit.value, 10);
    EXPECT_EQ(hit.axis, 0);
    // From between the two, either is the first; what lies behind does not count.
    EXPECT_EQ(raycast(tree.view(), {{4.5, 3.5, 4.5}, {1, 0, 0}}).value, 20);
    EXPECT_EQ(raycast(tree.view(), {{4.5, 3.5, 4.5}, {-1, 0, 0}}).value, 10);
    EXPECT_FALSE(raycast(tree.view(), {{7.5, 3.5, 4.5}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(tree.view(), {{9.0, 3.5, 4.5}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(tree.view(), {{-1.0, 3.5, 4.5}, {-1, 0, 0}}).hit);
    // Along the normalised direction, whatever its length.
    const RaycastHit slanted = raycast(tree.view(), {{2.5, 0.5, 0.5}, {0, 3e-7, 4e-7}});
    EXPECT_EQ(slanted.voxel, glm::ivec3(2, 3, 4));
    EXPECT_EQ(slanted.normal, glm::dvec3(0, 0, -1));
    EXPECT_NEAR(slanted.t, 3.5 / 4 * 5, 1e-12);
}

TEST(RaycastHits, WhatLiesBehindTheFirstIsNotRead) {
    // A wall, and noise behind it: the ray reads the same words whether the noise is there or not.
    DenseModel wall("wall", {32, 32, 32});
    for (int k = 0; k < 32 * 32; ++k) wall[{k % 32, 3, k / 32}] = 5;
    DenseModel noise = randomVoxels({32, 32, 32}, 0.3, 9);
    for (int k = 0; k < 32 * 32; ++k) {
        for (int y = 0; y < 3; ++y) noise[{k % 32, y, k / 32}] = 0;
        noise[{k % 32, 3, k / 32}] = 5;
    }
    for (const glm::dvec3 direction : {glm::dvec3(0, 1, 0), glm::dvec3(0.3, 1, -0.2)}) {
        RaycastCounters few;
        RaycastCounters many;
        const Ray ray{{16.5, -4, 16.5}, direction};
        EXPECT_EQ(raycast(NaiveOctree(wall).view(), ray, {}, &few).value, 5);
        EXPECT_EQ(raycast(NaiveOctree(noise).view(), ray, {}, &many).value, 5);
        EXPECT_LE(many.nodes, 5u * many.iterations);
        EXPECT_LE(many.iterations, 4u);
    }
}

TEST(RaycastHits, EmptyNodesArePassedInOneStep) {
    // 512 cubed and one voxel: a ray to it passes at most three empty nodes a level, not 512 cells.
    const NaiveOctree tree = needle(9, {300, 301, 302});
    RaycastCounters counters;
    const Ray ray{{-50, 301.5, 302.5}, {1, 0, 0}};
    const RaycastHit hit = raycast(tree.view(), ray, {}, &counters);
    EXPECT_EQ(hit.voxel, glm::ivec3(300, 301, 302));
    EXPECT_DOUBLE_EQ(hit.t, 350.0);
    EXPECT_LE(counters.iterations, 10u);
    EXPECT_LE(counters.nodes, 20u);
    EXPECT_EQ(counters.rays, 1u);
    EXPECT_EQ(counters.boxMisses, 0u);
    EXPECT_EQ(counters.guardReached, 0u);
    // Counters add up.
    EXPECT_FALSE(raycast(tree.view(), {{-50, 301.5, 302.5}, {-1, 0, 0}}, {}, &counters).hit);
    EXPECT_EQ(counters.rays, 2u);
    EXPECT_EQ(counters.boxMisses, 1u);
}

TEST(RaycastHits, ChildrenAreEnteredAtEveryDepth) {
    for (int depth = 1; depth <= kMaxOctreeDepth; ++depth) {
        const int last = (1 << depth) - 1;
        for (const glm::ivec3 voxel : {glm::ivec3(0), glm::ivec3(last), glm::ivec3(last, 0, last),
                                       glm::ivec3(last / 3, last / 2, last / 5)}) {
            const NaiveOctree tree = needle(depth, voxel);
            for (int axis = 0; axis < 3; ++axis) {
                for (const double side : {-1.0, 1.0}) {
                    glm::dvec3 direction(0.0);
                    direction[axis] = -side;
                    const glm::dvec3 eye = glm::dvec3(voxel) + 0.5 - direction * 2e5;
                    const RaycastHit hit = raycast(tree.view(), {eye, direction});
                    ASSERT_EQ(hit.value, 9) << "depth " << depth;
                    EXPECT_EQ(hit.voxel, voxel);
                    EXPECT_EQ(hit.normal, -direction);
                    EXPECT_DOUBLE_EQ(hit.t, 2e5 - 0.5);
                }
            }
        }
    }
}

// The values of a brick by octant: 1 ... 8 in the order of the GPU arrays, x in the lowest bit.
TEST(RaycastOctants, EveryOctantIsMetFromEverySide) {
    DenseModel model("octants", {2, 2, 2});
    for (unsigned o = 0; o < 8; ++o) model[octantCorner(o)] = static_cast<std::uint8_t>(o + 1);
    const NaiveOctree tree(model);
    for (int signs = 0; signs < 8; ++signs) {
        const glm::dvec3 direction((signs & 1) != 0 ? -1.0 : 1.0, (signs & 2) != 0 ? -1.0 : 1.0,
                                   (signs & 4) != 0 ? -1.0 : 1.0);
        for (unsigned o = 0; o < 8; ++o) {
            // At the octant's middle, slowest on z: it starts there, in the octant.
            const glm::dvec3 middle = glm::dvec3(octantCorner(o)) + 0.5;
            const glm::dvec3 slanted = direction * glm::dvec3(1.0, 0.9, 0.8);
            EXPECT_EQ(raycast(tree.view(), {middle, slanted}).value, o + 1);
            // From outside the octant that the line enters first lies at the near corner.
            const RaycastHit hit = raycast(tree.view(), {glm::dvec3(1.0) - slanted * 5.0, slanted});
            EXPECT_EQ(hit.value, static_cast<unsigned>(signs) + 1);
        }
    }
}

// A minimum face looks down its axis, a maximum face up.
TEST(RaycastNormals, AreThoseOfTheFaceEntered) {
    const NaiveOctree tree(solid({3, 3, 3}, 1));
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 outward(0.0);
            outward[axis] = side;
            // Slanted, but through the middle of the face.
            glm::dvec3 direction = -outward;
            direction[(axis + 1) % 3] = 0.25;
            direction[(axis + 2) % 3] = -0.125;
            const glm::dvec3 middle = glm::dvec3(1.5) + outward * 1.5;
            const RaycastHit hit = raycast(tree.view(), {middle - direction * 4.0, direction});
            EXPECT_EQ(hit.normal, outward);
            EXPECT_EQ(hit.point, middle);
            EXPECT_EQ(hit.axis, axis);
        }
    }
}

// At an edge or a corner the crossings are ordered by axis, so the face is that of the last of
// them: the highest axis among those crossed at once into the cube.
TEST(RaycastNormals, EdgesAndCornersHaveOne) {
    const NaiveOctree tree(solid({2, 2, 2}, 1));
    const auto normalOf = [&](glm::dvec3 at, glm::dvec3 direction) {
        const RaycastHit hit = raycast(tree.view(), {at - direction * 3.0, direction});
        EXPECT_TRUE(hit.hit);
        EXPECT_EQ(hit.point, at);
        return hit.normal;
    };
    EXPECT_EQ(normalOf({0, 0, 1}, {1, 1, 0}), glm::dvec3(0, -1, 0));
    EXPECT_EQ(normalOf({0, 1, 0}, {1, 0, 1}), glm::dvec3(0, 0, -1));
    EXPECT_EQ(normalOf({2, 0, 1}, {-1, 1, 0}), glm::dvec3(0, -1, 0));
    EXPECT_EQ(normalOf({0, 0, 0}, {1, 1, 1}), glm::dvec3(0, 0, -1));
    EXPECT_EQ(normalOf({2, 2, 2}, {-1, -0.5, -0.25}), glm::dvec3(0, 0, 1));
}

TEST(RaycastNormals, InsideTheyLookBackAlongTheRay) {
    const NaiveOctree tree(solid({4, 4, 4}, 3));
    const RaycastHit hit = raycast(tree.view(), {{1.25, 2.5, 3.75}, {0.3, -0.9, 0.2}});
    ASSERT_TRUE(hit.hit);
    EXPECT_EQ(hit.t, 0.0);
    EXPECT_EQ(hit.point, glm::dvec3(1.25, 2.5, 3.75));
    EXPECT_EQ(hit.voxel, glm::ivec3(1, 2, 3));
    EXPECT_EQ(hit.normal, glm::dvec3(0, 1, 0));
}

TEST(RaycastSteps, AxesAlongWhichNothingMoves) {
    const NaiveOctree tree(pairOfVoxels());
    for (const double zero : {0.0, -0.0}) {
        EXPECT_EQ(raycast(tree.view(), {{9, 3.5, 4.5}, {-1, zero, zero}}).value, 20);
        EXPECT_EQ(raycast(tree.view(), {{2.5, 9, 4.5}, {zero, -1, zero}}).value, 10);
        EXPECT_EQ(raycast(tree.view(), {{6.5, 3.5, -2}, {zero, zero, 1}}).value, 20);
        EXPECT_EQ(raycast(tree.view(), {{2.5, 2.5, 3.5}, {zero, 1, 1}}).value, 10);
        EXPECT_FALSE(raycast(tree.view(), {{9, 4.5, 4.5}, {-1, zero, zero}}).hit);
        EXPECT_FALSE(raycast(tree.view(), {{9, 8.0, 4.5}, {-1, zero, zero}}).hit);
        EXPECT_FALSE(raycast(tree.view(), {{9, -0.5, 4.5}, {-1, zero, zero}}).hit);
    }
}

// Cells are half open: a ray along a face, an edge or through corners is in the cell above.
TEST(RaycastSteps, RaysAlongFaces) {
    const NaiveOctree tree(pairOfVoxels());
    EXPECT_EQ(raycast(tree.view(), {{-1, 3.0, 4.5}, {1, 0, 0}}).value, 10);
    EXPECT_EQ(raycast(tree.view(), {{-1, 3.0, 4.0}, {1, 0, 0}}).value, 10);
    EXPECT_FALSE(raycast(tree.view(), {{-1, 4.0, 4.5}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(tree.view(), {{-1, 3.5, 5.0}, {1, 0, 0}}).hit);
    const NaiveOctree full(solid({8, 8, 8}, 2));
    EXPECT_TRUE(raycast(full.view(), {{-1, 0.0, 0.0}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(full.view(), {{-1, 8.0, 4.0}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(full.view(), {{8.0, 4.0, 4.0}, {1, 0, 0}}).hit);
    EXPECT_EQ(raycast(full.view(), {{8.0, 4.0, 4.0}, {-1, 0, 0}}).t, 0.0);
    EXPECT_TRUE(raycast(full.view(), {{0.0, 4.0, 4.0}, {1, 0, 0}}).hit);
    EXPECT_FALSE(raycast(full.view(), {{0.0, 4.0, 4.0}, {-1, 0, 0}}).hit);
}

// Where no ray should slip through: at a closed wall, from any side, however it grazes.
TEST(RaycastSteps, NothingSlipsThroughAWall) {
    DenseModel model("wall", {64, 64, 64});
    for (int k = 0; k < 64 * 64; ++k) model[{k % 64, 31, k / 64}] = 1;
    const NaiveOctree tree(model);
    Rays rays(2);
    for (int n = 0; n < 20000; ++n) {
        // From one side to the other, almost along the wall.
        const double lean = std::pow(10.0, -rays.among(0, 5));
        Ray ray{{8, 31.5 - 24 * lean, 8}, {1, lean, rays.among(-4, 4) / 8.0}};
        ray.origin.z += rays.among(0, 8 * 32) / 8.0 + (ray.direction.z < 0 ? 16.0 : 0.0);
        ray.origin.x += rays.among(0, 64) / 128.0;
        if (n % 2 != 0) ray.origin.y += rays.among(-3, 3) * 1e-7;
        ASSERT_TRUE(raycast(tree.view(), ray).hit) << describe(ray);
    }
}

TEST(RaycastBox, IsTestedBeforeTheTree) {
    const NaiveOctree tree(pairOfVoxels());
    RaycastCounters counters;
    const std::vector<Ray> past{{{-1, 9, 4}, {1, 0, 0}},      {{-1, 4, 4}, {-1, 0, 0}},
                                {{-1, -1, -1}, {1, 1, -1}},   {{20, 20, 20}, {1, 1, 1}},
                                {{-4, 4, 4}, {1, 10, 0}},     {{4, 4, 20}, {0.1, 0.1, 1}},
                                {{-8, -40, 4}, {1, 1, 0.001}}};
    for (const Ray& ray : past) EXPECT_FALSE(raycast(tree.view(), ray, {}, &counters).hit);
    EXPECT_EQ(counters.rays, past.size());
    EXPECT_EQ(counters.boxMisses, past.size());
    EXPECT_EQ(counters.nodes, 0u);
    EXPECT_EQ(counters.iterations, 0u);
    EXPECT_FALSE(raycast(Octree{}.view(), {{-1, 0, 0}, {1, 0, 0}}, {}, &counters).hit);
    EXPECT_EQ(counters.boxMisses, past.size() + 1);
}

}  // namespace
}  // namespace voxprite::test
