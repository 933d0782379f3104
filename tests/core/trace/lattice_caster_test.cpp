#include "core/trace/lattice_caster.h"

#include <gtest/gtest.h>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/exact_caster.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

std::vector<DenseModel> smallModels() {
    std::vector<DenseModel> models;
    models.push_back(solid({1, 1, 1}, 7));
    models.push_back(solid({8, 8, 8}, 200));
    models.push_back(solid({5, 3, 6}, 9));
    models.push_back(randomVoxels({1, 1, 13}, 0.4, 1));
    models.push_back(randomVoxels({16, 1, 2}, 0.3, 2));
    models.push_back(randomVoxels({7, 11, 5}, 0.02, 3));
    models.push_back(randomVoxels({16, 16, 16}, 0.005, 4));
    models.push_back(randomVoxels({9, 9, 9}, 0.5, 5));
    models.push_back(randomVoxels({17, 6, 10}, 0.01, 6));
    models.push_back(shell(16));
    models.push_back(figure(1));
    return models;
}

// Rays that run through edges and corners of the grid, along faces, and that start on them; every
// other one is an ordinary ray of a sprite.
class RayMaker {
  public:
    explicit RayMaker(unsigned seed) : random_(seed) {}

    LatticeRay next(glm::ivec3 size) {
        LatticeRay ray;
        ray.positionBits = std::uniform_int_distribution<int>(1, 10)(random_);
        const bool special = (count_++ & 1) != 0;
        const int reach = special ? 3 : 8192;
        const int grain = special ? 1 << (ray.positionBits - 1) : 1;
        std::uniform_int_distribution<int> component(-reach, reach);
        do {
            ray.direction = {component(random_), component(random_), component(random_)};
        } while (ray.direction == glm::ivec3(0));
        // A point in or beside the box, then any other point of the line through it.
        std::uniform_int_distribution<int> along(special ? -8 : -2, special ? 8 : 2);
        const std::int64_t slide = std::int64_t{along(random_)} * (special ? grain : 1);
        for (int a = 0; a < 3; ++a) {
            const int edge = (size[a] << ray.positionBits) / grain;
            std::uniform_int_distribution<int> start(-2, edge + 2);
            ray.origin[a] = std::int64_t{start(random_)} * grain + slide * ray.direction[a];
        }
        return ray;
    }

  private:
    std::mt19937 random_;
    unsigned count_ = 0;
};

TEST(LatticeCaster, EqualsTheSortedListOfAllCrossings) {
    RayMaker rays(11);
    for (const DenseModel& model : smallModels()) {
        const NaiveOctree tree(model);
        int hits = 0;
        for (int n = 0; n < 30000; ++n) {
            const LatticeRay ray = rays.next(model.size);
            const LatticeHit exact = castExact(model, ray);
            const LatticeHit hit = castLattice(tree.view(), ray);
            ASSERT_TRUE(sameHit(hit, exact)) << model.name << " " << describe(ray) << "\n got "
                                             << describe(hit) << "\nwant " << describe(exact);
            hits += exact.material != 0;
        }
        EXPECT_GT(hits, 300) << model.name;
    }
}

// Every direction with components -2 ... 2 through every half-voxel point of a small block.
TEST(LatticeCaster, EveryTieOfASmallGridIsResolvedByTheRule) {
    const DenseModel model = randomVoxels({3, 3, 3}, 0.5, 21);
    const NaiveOctree tree(model);
    LatticeRay ray;
    ray.positionBits = 1;
    for (int d = 0; d < 125; ++d) {
        ray.direction = {d % 5 - 2, d / 5 % 5 - 2, d / 25 - 2};
        if (ray.direction == glm::ivec3(0)) continue;
        for (int o = 0; o < 9 * 9 * 9; ++o) {
            ray.origin = {o % 9 - 1, o / 9 % 9 - 1, o / 81 - 1};
            const LatticeHit exact = castExact(model, ray);
            const LatticeHit hit = castLattice(tree.view(), ray);
            ASSERT_TRUE(sameHit(hit, exact))
                << describe(ray) << "\n got " << describe(hit) << "\nwant " << describe(exact);
        }
    }
}

// Answers worked out by hand from the rule.
TEST(LatticeCaster, KnownAnswers) {
    DenseModel model("pair", {2, 2, 2});
    model[{1, 0, 0}] = 3;
    model[{1, 1, 1}] = 5;
    const NaiveOctree tree(model);
    const auto cast = [&](glm::i64vec3 origin, glm::ivec3 direction) {
        return castLattice(tree.view(), {origin, direction, 4});
    };
    // Through the block's corner along its diagonal: x is crossed first at every tie, so the line
    // passes (1,0,0) on its way from (0,0,0) to (1,1,1).
    EXPECT_EQ(describe(cast({0, 0, 0}, {1, 1, 1})), "material 3 at 1,0,0 through axis 0");
    // Backward z is crossed last into the far corner, which is solid.
    EXPECT_EQ(describe(cast({32, 32, 32}, {-1, -1, -1})), "material 5 at 1,1,1 through axis 2");
    // Along a face between two cells: cells are half open, the upper one has it.
    EXPECT_EQ(describe(cast({16, 8, 8}, {0, 1, 0})), "material 3 at 1,0,0 through axis 1");
    EXPECT_EQ(describe(cast({15, 8, 8}, {0, 1, 0})), "nothing");
    EXPECT_EQ(describe(cast({32, 8, 8}, {0, 1, 0})), "nothing");
    // The whole line counts, not only what lies ahead of its origin.
    EXPECT_EQ(describe(cast({24, 1600, 8}, {0, 1, 0})), "material 3 at 1,0,0 through axis 1");
    EXPECT_EQ(describe(cast({24, 24, -1600}, {0, 0, -1})), "material 5 at 1,1,1 through axis 2");
}

TEST(LatticeCaster, EmptyModelsAreNeverHit) {
    const DenseModel model("empty", {4, 4, 4});
    EXPECT_EQ(castLattice(NaiveOctree(model).view(), {{0, 0, 0}, {1, 2, 3}, 8}).material, 0);
    EXPECT_EQ(castLattice(Octree{}.view(), {{0, 0, 0}, {1, 2, 3}, 8}).material, 0);
}

// The live octree keeps its own origin, and bounds may reach beyond its root.
TEST(LatticeCaster, TheOctreesOriginChangesNothing) {
    const DenseModel model = randomVoxels({7, 5, 6}, 0.1, 31);
    const NaiveOctree canonical(model);
    RayMaker rays(32);
    std::mt19937 random(33);
    for (int round = 0; round < 40; ++round) {
        std::uniform_int_distribution<int> offset(0, 64 - 7);
        const NaiveOctree live(model, 6, {offset(random), offset(random), offset(random)});
        for (int n = 0; n < 500; ++n) {
            const LatticeRay ray = rays.next(model.size);
            const LatticeHit hit = castLattice(live.view(), ray);
            const LatticeHit want = castLattice(canonical.view(), ray);
            ASSERT_TRUE(sameHit(hit, want))
                << describe(ray) << "\n got " << describe(hit) << "\nwant " << describe(want);
        }
    }
}

TEST(LatticeCaster, WhatLiesOutsideTheRootIsEmpty) {
    const DenseModel model = randomVoxels({12, 12, 12}, 0.2, 41);
    RayMaker rays(42);
    for (const glm::ivec3 offset : {glm::ivec3(-3, 0, 0), glm::ivec3(-2, -5, 3),
                                    glm::ivec3(4, 4, -4), glm::ivec3(-9, 2, 20)}) {
        const NaiveOctree live(model, 3, offset);
        DenseModel visible = model;
        for (int z = 0; z < 12; ++z)
            for (int y = 0; y < 12; ++y)
                for (int x = 0; x < 12; ++x) {
                    const glm::ivec3 tree = glm::ivec3(x, y, z) + offset;
                    if (!IBox{glm::ivec3(0), glm::ivec3(8)}.contains(tree)) visible[{x, y, z}] = 0;
                }
        for (int n = 0; n < 5000; ++n) {
            const LatticeRay ray = rays.next(model.size);
            const LatticeHit hit = castLattice(live.view(), ray);
            const LatticeHit want = castExact(visible, ray);
            ASSERT_TRUE(sameHit(hit, want))
                << describe(ray) << "\n got " << describe(hit) << "\nwant " << describe(want);
        }
    }
}

// Bounds smaller than what the octree holds: the rest is not seen, whichever way it lies.
TEST(LatticeCaster, SolidVoxelsOutsideTheSizeAreNotSeen) {
    const DenseModel model = randomVoxels({16, 16, 16}, 0.3, 51);
    const NaiveOctree whole(model);
    OctreeView cut = whole.view();
    cut.size = {6, 5, 9};
    cut.treeFromVoxel = {3, 7, 2};
    DenseModel inside("cut", cut.size);
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x)
                inside[{x, y, z}] = model.at(glm::ivec3(x, y, z) + cut.treeFromVoxel);
    RayMaker rays(52);
    for (int n = 0; n < 30000; ++n) {
        const LatticeRay ray = rays.next(cut.size);
        const LatticeHit hit = castLattice(cut, ray);
        const LatticeHit want = castExact(inside, ray);
        ASSERT_TRUE(sameHit(hit, want))
            << describe(ray) << "\n got " << describe(hit) << "\nwant " << describe(want);
    }
}

// The largest model there is, at the finest lattice: 64 bits hold, which the sanitizers confirm.
TEST(LatticeCaster, TheLargestModelFits64Bits) {
    const int edge = 1 << 16;
    // A root of 16 levels with one solid voxel in each of two opposite corners.
    Octree octree;
    octree.size = glm::ivec3(edge);
    octree.maxDepth = 16;
    octree.nodes.clear();
    octree.nodes.push_back(node::internal(1, 0x81));
    for (std::uint32_t level = 15; level >= 2; --level) {
        const auto next = static_cast<std::uint32_t>(octree.nodes.size()) + 2;
        octree.nodes.push_back(node::internal(next, 0x01));
        octree.nodes.push_back(node::internal(next + 1, 0x80));
    }
    octree.nodes.push_back(node::brick(0));
    octree.nodes.push_back(node::brick(1));
    octree.payloads = {0x01, std::uint64_t{2} << 56};
    const std::int64_t far = std::int64_t{edge} << 10;
    const auto cast = [&](glm::i64vec3 origin, glm::ivec3 direction) {
        return describe(castLattice(octree.view(), {origin, direction, 10}));
    };
    const std::string first = "material 1 at 0,0,0 through axis ";
    const std::string second = "material 2 at 65535,65535,65535 through axis ";
    EXPECT_EQ(cast({far / 2, far / 2, far / 2}, {8192, 8192, 8192}), first + "2");
    EXPECT_EQ(cast({far / 2, far / 2, far / 2}, {-8192, -8192, -8192}), second + "2");
    EXPECT_EQ(cast({-far, 5, 5}, {8191, 0, 0}), first + "0");
    EXPECT_EQ(cast({far - 5, far - 5, -far}, {0, 0, -1}), second + "2");
    EXPECT_EQ(cast({far - 5 - 8191 * 8192LL, far - 5 - 8190 * 8192LL, far - 5 - 8192 * 8192LL},
                   {8191, 8190, 8192}),
              second + "2");
    EXPECT_EQ(cast({far / 2, far / 2, far / 2}, {8192, 8192, -8192}), "nothing");
}

TEST(LatticeCaster, AWholeViewGivesTheSameHitsAsItsRays) {
    std::mt19937 random(61);
    for (const DenseModel& model : smallModels()) {
        const NaiveOctree live(model, 7, {40, 9, 77});
        std::vector<OrthoView> views;
        for (const glm::dvec3& direction : canonicalDirections())
            views.push_back(viewAlong(direction, 2));
        for (int n = 0; n < 4; ++n) views.push_back(randomView(random, 3));
        for (const OrthoView& view : views) {
            const LatticeView lattice = quantiseView(view, model.size).value();
            const LatticeCaster caster(live.view(), lattice);
            for (int j = 0; j < lattice.size.y; ++j) {
                for (int i = 0; i < lattice.size.x; ++i) {
                    const glm::ivec2 pixel = lattice.first + glm::ivec2(i, j);
                    const LatticeHit hit = caster.cast(pixel);
                    const LatticeHit exact = castExact(model, rayOf(lattice, pixel));
                    ASSERT_TRUE(sameHit(hit, exact)) << model.name << " pixel " << i << " " << j;
                }
            }
        }
    }
}

TEST(LatticeCaster, RaysOfAViewRoundDown) {
    LatticeView lattice;
    lattice.positionBits = 8;
    lattice.C = {100, 200, 300};
    lattice.D = {1, 2, 3};
    lattice.U = {4096, -1, 5000};
    lattice.V = {0, 4095, -5000};
    const LatticeRay ray = rayOf(lattice, {-3, 1});
    EXPECT_EQ(ray.origin, glm::i64vec3(97, 201, 295));  // 4098 >> 12 = 1, -20000 >> 12 = -5
    EXPECT_EQ(rayOf(lattice, {1, 0}).origin, glm::i64vec3(101, 199, 301));
    EXPECT_EQ(rayOf(lattice, {0, 1}).origin, glm::i64vec3(100, 200, 298));
    EXPECT_EQ(ray.direction, glm::ivec3(1, 2, 3));
    EXPECT_EQ(ray.positionBits, 8);
}

}  // namespace
}  // namespace voxprite::test
