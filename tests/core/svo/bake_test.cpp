#include "core/svo/bake.h"
#include "core/svo/bake_on_threads.h"

#include <gtest/gtest.h>

#include "core/svo/validate.h"
#include "tests/core/svo/reference_octree.h"

namespace voxprite {
namespace {

using Words = std::vector<std::uint32_t>;
using Payloads = std::vector<std::uint64_t>;

Octree baked(const VoxelGrid& voxels) {
    const Result<Octree> octree = bake(voxels);
    EXPECT_TRUE(octree.has_value());
    return octree.value_or(Octree{});
}

void expectSameVoxels(const Octree& octree, const VoxelGrid& voxels, const IBox& bounds) {
    ASSERT_EQ(octree.size, bounds.size());
    ASSERT_EQ(octree.origin, bounds.min);
    const VoxelGrid::Reader reader(voxels);
    const unsigned edge = 1u << octree.maxDepth;
    std::uint64_t wrong = 0;
    for (unsigned x = 0; x < edge; ++x) {
        for (unsigned y = 0; y < edge; ++y) {
            for (unsigned z = 0; z < edge; ++z) {
                const glm::ivec3 v = glm::ivec3(x, y, z) + bounds.min;
                const std::uint8_t expected = bounds.contains(v) ? reader.get(v) : 0;
                const std::uint8_t decoded =
                    test::decodeVoxel(octree.nodes, octree.payloads, octree.maxDepth, x, y, z);
                wrong += decoded != expected;
                wrong += materialAt(octree.view(), glm::ivec3(x, y, z)) != expected;
            }
        }
    }
    EXPECT_EQ(wrong, 0u);
}

TEST(Bake, EmptyModelIsAnEmptyRoot) {
    const Octree octree = baked(VoxelGrid{});
    EXPECT_EQ(octree.nodes, Words{0});
    EXPECT_TRUE(octree.payloads.empty());
    EXPECT_EQ(octree.maxDepth, 1);
    EXPECT_EQ(octree.size, glm::ivec3(0));
    EXPECT_TRUE(validateCanonical(octree));
}

TEST(Bake, EmptyFrameKeepsTheSizeOfItsEntity) {
    const Octree octree = bake(VoxelGrid{}, {{-2, 0, 0}, {3, 4, 9}}).value();
    EXPECT_EQ(octree.nodes, Words{0});
    EXPECT_EQ(octree.maxDepth, 4);
    EXPECT_EQ(octree.size, glm::ivec3(5, 4, 9));
    EXPECT_EQ(octree.origin, glm::ivec3(-2, 0, 0));
    EXPECT_TRUE(validateCanonical(octree));
}

// The words below are computed by hand from the format's description.

TEST(Bake, OneVoxelIsABrickAtTheRoot) {
    VoxelGrid voxels;
    voxels.set({-5, 100, 7}, 9);
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.nodes, Words{0x4000'0000});
    EXPECT_EQ(octree.payloads, Payloads{0x09});
    EXPECT_EQ(octree.maxDepth, 1);
    EXPECT_EQ(octree.size, glm::ivec3(1));
    EXPECT_EQ(octree.origin, glm::ivec3(-5, 100, 7));
}

TEST(Bake, FullTwoCubeIsAUniformRoot) {
    VoxelGrid voxels;
    voxels.fill({{1, 1, 1}, {3, 3, 3}}, 42);
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.nodes, Words{42});
    EXPECT_TRUE(octree.payloads.empty());
    EXPECT_EQ(octree.maxDepth, 1);
}

TEST(Bake, MixedTwoCubeHasItsOctantsInOrder) {
    VoxelGrid voxels;
    for (int i = 0; i < 8; ++i) {
        voxels.set({i & 1, i >> 1 & 1, i >> 2}, static_cast<std::uint8_t>(0x11 * (i + 1)));
    }
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.nodes, Words{0x4000'0000});
    EXPECT_EQ(octree.payloads, Payloads{0x8877'6655'4433'2211});
}

TEST(Bake, ThreeVoxelsInARow) {
    VoxelGrid voxels;
    for (int x = 0; x < 3; ++x) voxels.set({x, 0, 0}, static_cast<std::uint8_t>(x + 1));
    const Octree octree = baked(voxels);
    // Root: children 0 (x 0..1) and 1 (x 2..3) from node 1 on.
    EXPECT_EQ(octree.nodes, (Words{0x8000'0103, 0x4000'0000, 0x4000'0001}));
    EXPECT_EQ(octree.payloads, (Payloads{0x0201, 0x03}));
    EXPECT_EQ(octree.maxDepth, 2);
    EXPECT_EQ(octree.size, glm::ivec3(3, 1, 1));
}

TEST(Bake, UniformFourCubeCollapsesToTheRoot) {
    VoxelGrid voxels;
    for (int i = 0; i < 64; ++i) voxels.set({i & 3, i >> 2 & 3, i >> 4}, 200);
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.nodes, Words{200});
    EXPECT_TRUE(octree.payloads.empty());
    EXPECT_EQ(octree.maxDepth, 2);

    voxels.set({3, 3, 3}, 201);  // the last voxel of the last octant
    const Octree split = baked(voxels);
    EXPECT_EQ(split.nodes, (Words{0x8000'01FF, 200, 200, 200, 200, 200, 200, 200, 0x4000'0000}));
    EXPECT_EQ(split.payloads, Payloads{0xC9C8'C8C8'C8C8'C8C8});
}

TEST(Bake, NodesLieBreadthFirst) {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 1);
    voxels.set({7, 0, 0}, 2);
    voxels.set({0, 0, 7}, 3);
    const Octree octree = baked(voxels);
    // Root -> octants 0 (x,z low), 1 (x high), 4 (z high) at 1..3; each has one brick, at 4..6.
    EXPECT_EQ(octree.nodes, (Words{0x8000'0113, 0x8000'0401, 0x8000'0502, 0x8000'0610, 0x4000'0000,
                                   0x4000'0001, 0x4000'0002}));
    // Voxel 7 is the upper half of its brick: x bit 1 is octant 1, z bit is octant 4.
    EXPECT_EQ(octree.payloads, (Payloads{1, 2ull << 8, 3ull << 32}));
}

TEST(Bake, AThinColumnOf256) {
    for (int axis = 0; axis < 3; ++axis) {
        VoxelGrid voxels;
        for (int i = 0; i < 256; ++i) {
            glm::ivec3 v(0);
            v[axis] = i;
            voxels.set(v, static_cast<std::uint8_t>(1 + i % 255));
        }
        const Octree octree = baked(voxels);
        EXPECT_EQ(octree.maxDepth, 8);
        EXPECT_EQ(octree.nodes.size(), 255u);  // 1 + 2 + ... + 128
        EXPECT_EQ(octree.payloads.size(), 128u);
        EXPECT_TRUE(validateCanonical(octree));
        EXPECT_EQ(toVoxels(octree), voxels);
    }
}

TEST(Bake, RandomModelsAgreeWithThePlainBakerAndDecoder) {
    std::mt19937 random(1);
    for (int i = 0; i < 150; ++i) {
        const glm::ivec3 centre = test::randomIn(random, glm::ivec3(-600), glm::ivec3(600));
        const VoxelGrid voxels = test::randomModel(random, centre, 1 + i % 37);
        if (voxels.empty()) continue;
        const IBox bounds = voxels.bounds();
        const Octree octree = baked(voxels);
        const Status valid = validateCanonical(octree);
        EXPECT_TRUE(valid.has_value()) << valid.error().describe();
        EXPECT_EQ(octree, test::ReferenceBaker(voxels, bounds).bake()) << "model " << i;
        expectSameVoxels(octree, voxels, bounds);
        EXPECT_EQ(toVoxels(octree), voxels);
    }
}

TEST(Bake, OtherBoundsCutOrPad) {
    std::mt19937 random(2);
    for (int i = 0; i < 60; ++i) {
        const VoxelGrid voxels = test::randomModel(random, {0, 0, 0}, 24);
        const IBox bounds = IBox::around(test::randomIn(random, glm::ivec3(-20), glm::ivec3(20)),
                                         test::randomIn(random, glm::ivec3(-20), glm::ivec3(20)));
        const Octree octree = bake(voxels, bounds).value();
        EXPECT_TRUE(validateCanonical(octree));
        EXPECT_EQ(octree, test::ReferenceBaker(voxels, bounds).bake());
    }
}

TEST(Bake, HowVoxelsAreStoredDoesNotCount) {
    // The same solid as tiles and as single voxels, at an offset that lies across all tiles.
    const IBox box{{-37, 3, 11}, {60, 70, 90}};
    VoxelGrid filled;
    filled.fill(box, 6);
    VoxelGrid single;
    for (int x = box.min.x; x < box.max.x; ++x) {
        for (int y = box.min.y; y < box.max.y; ++y) {
            for (int z = box.min.z; z < box.max.z; ++z) single.set({x, y, z}, 6);
        }
    }
    const Octree octree = baked(filled);
    EXPECT_EQ(octree, baked(single));
    EXPECT_TRUE(validateCanonical(octree));
    EXPECT_EQ(toVoxels(octree), filled);
}

TEST(Bake, HugeSolidsStaySmall) {
    VoxelGrid voxels;
    voxels.fill({{-100, -100, -100}, {924, 924, 924}}, 3);
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.nodes, Words{3});
    EXPECT_EQ(octree.maxDepth, 10);
}

TEST(Bake, TheLongestEdgeIs65536) {
    VoxelGrid voxels;
    voxels.set({-40000, 5, 5}, 1);
    voxels.set({25535, 5, 5}, 2);
    const Octree octree = baked(voxels);
    EXPECT_EQ(octree.size.x, 65536);
    EXPECT_EQ(octree.maxDepth, 16);
    EXPECT_TRUE(validateCanonical(octree));
    EXPECT_EQ(toVoxels(octree), voxels);

    voxels.set({25536, 5, 5}, 2);
    const Result<Octree> tooLong = bake(voxels);
    ASSERT_FALSE(tooLong.has_value());
    EXPECT_NE(tooLong.error().message.find("65,536"), std::string::npos);
}

// On any number of threads, as the plain baker has it.
void expectOneOctree(const VoxelGrid& voxels, const IBox& bounds, const Octree& expected) {
    for (const int threads : {0, 1, 2, 5}) {
        const Result<Octree> octree = bakeOnThreads(voxels, bounds, threads);
        ASSERT_TRUE(octree.has_value());
        EXPECT_EQ(*octree, expected) << threads << " threads";
    }
}

TEST(Bake, IsTheSameOnAnyNumberOfThreads) {
    // Large enough for several threads, at each offset from the grid's blocks.
    std::mt19937 random(3);
    for (int i = 0; i < 4; ++i) {
        const glm::ivec3 low = test::randomIn(random, glm::ivec3(-300), glm::ivec3(300));
        VoxelGrid voxels;
        voxels.fill({low + 10, low + 79}, 4);                                          // tiles, too
        voxels.fill({low + glm::ivec3(0, 0, 90), low + glm::ivec3(110, 110, 91)}, 5);  // a sheet
        for (int k = 0; k < 3000; ++k) {
            const auto material = static_cast<std::uint8_t>(random() % 4);
            voxels.set(test::randomIn(random, low, low + 110), material);
        }
        const IBox bounds = voxels.bounds();
        expectOneOctree(voxels, bounds, test::ReferenceBaker(voxels, bounds).bake());
        // Bounds that cut on every side, and that leave room on every side.
        const IBox within{bounds.min + 3, bounds.max - 5};
        expectOneOctree(voxels, within, test::ReferenceBaker(voxels, within).bake());
        const IBox around{bounds.min - 7, bounds.max + 2};
        expectOneOctree(voxels, around, test::ReferenceBaker(voxels, around).bake());
    }
}

TEST(Bake, EveryOffsetFromTheBlocksOfTheGrid) {
    std::mt19937 random(4);
    for (int offset = 0; offset < 512; ++offset) {
        const glm::ivec3 low(offset & 7, offset >> 3 & 7, offset >> 6);
        VoxelGrid voxels;
        voxels.set(low, 9);
        voxels.fill({low + 1, low + glm::ivec3(9, 10, 11)}, 1);
        for (int k = 0; k < 40; ++k) {
            voxels.set(test::randomIn(random, low, low + 19),
                       static_cast<std::uint8_t>(random() % 3));
        }
        const IBox bounds = voxels.bounds();
        EXPECT_EQ(baked(voxels), test::ReferenceBaker(voxels, bounds).bake())
            << "offset " << offset;
    }
}

TEST(Bake, HugeSparseModelsOnThreads) {
    // Clusters far apart: long ways down with nothing beside them.
    std::mt19937 random(5);
    VoxelGrid voxels;
    for (int i = 0; i < 40; ++i) {
        const glm::ivec3 at = test::randomIn(random, glm::ivec3(-30000), glm::ivec3(30000));
        voxels.fill(IBox::around(at, at + test::randomIn(random, glm::ivec3(1), glm::ivec3(20))),
                    static_cast<std::uint8_t>(1 + i));
    }
    const IBox bounds = voxels.bounds();
    const Octree octree = bakeOnThreads(voxels, bounds, 1).value();
    EXPECT_TRUE(validateCanonical(octree));
    EXPECT_EQ(toVoxels(octree), voxels);
    expectOneOctree(voxels, bounds, octree);
}

TEST(Bake, ThinModelsOnThreads) {
    for (int axis = 0; axis < 3; ++axis) {
        VoxelGrid voxels;
        for (int i = 0; i < 3000; ++i) {
            glm::ivec3 v(-5);
            v[axis] = i - 1234;
            voxels.set(v, static_cast<std::uint8_t>(1 + i / 7 % 255));
        }
        const IBox bounds = voxels.bounds();
        const Octree octree = bakeOnThreads(voxels, bounds, 1).value();
        EXPECT_TRUE(validateCanonical(octree));
        EXPECT_EQ(toVoxels(octree), voxels);
        expectOneOctree(voxels, bounds, octree);
    }
}

TEST(Bake, TooManyNodesIsAnError) {
    // One voxel in every brick of a 400-cube: 200^3 bricks, and a seventh more above them.
    VoxelGrid voxels;
    for (int x = 0; x < 400; x += 2) {
        for (int y = 0; y < 400; y += 2) {
            for (int z = 0; z < 400; z += 2) voxels.set({x, y, z}, 1);
        }
    }
    for (const int threads : {0, 1}) {
        const Result<Octree> octree = bakeOnThreads(voxels, voxels.bounds(), threads);
        ASSERT_FALSE(octree.has_value());
        EXPECT_NE(octree.error().message.find("8,388,608"), std::string::npos);
    }
}

TEST(Bake, AlmostTooManyNodesAreBaked) {
    // 200 x 200 x 183 bricks of one voxel each and what is above them: as near as whole layers get.
    VoxelGrid voxels;
    for (int x = 0; x < 400; x += 2) {
        for (int y = 0; y < 400; y += 2) {
            for (int z = 0; z < 366; z += 2) voxels.set({x, y, z}, 1);
        }
    }
    const Octree octree = bake(voxels, voxels.bounds()).value();
    EXPECT_GT(octree.nodes.size(), kMaxOctreeNodes - 50'000u);
    EXPECT_LE(octree.nodes.size(), kMaxOctreeNodes);
    EXPECT_EQ(octree, bakeOnThreads(voxels, voxels.bounds(), 1).value());
    EXPECT_TRUE(validateCanonical(octree));
}

}  // namespace
}  // namespace voxprite
