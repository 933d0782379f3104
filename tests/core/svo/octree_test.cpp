#include "core/svo/octree.h"

#include <gtest/gtest.h>

namespace voxprite {
namespace {

TEST(NodeWord, BitsAreThoseOfTheFormat) {
    EXPECT_EQ(node::uniform(200), 0x0000'00C8u);
    EXPECT_EQ(node::brick(5), 0x4000'0005u);
    EXPECT_EQ(node::internal(3, 0xA1), 0x8000'03A1u);
    EXPECT_EQ(node::internal(kMaxOctreeNodes - 1, 0xFF), 0xFFFF'FFFFu);
    EXPECT_EQ(node::childBase(0xFFFF'FFFFu), kMaxOctreeNodes - 1);
    EXPECT_EQ(node::payloadIndex(0x7FFF'FFFFu), 0x3FFF'FFFFu);

    EXPECT_TRUE(node::isEmpty(0));
    EXPECT_TRUE(node::isUniform(1));
    EXPECT_FALSE(node::isUniform(0));
    EXPECT_TRUE(node::isBrick(0x4000'0000u));
    EXPECT_FALSE(node::isBrick(0xC000'0001u));
    EXPECT_TRUE(node::isInternal(0xC000'0001u));
}

TEST(NodeWord, ChildrenAreCountedBelowTheirOctant) {
    const std::uint32_t word = node::internal(10, 0b1010'0110);
    EXPECT_FALSE(node::hasChild(word, 0));
    EXPECT_EQ(node::childIndex(word, 1), 10u);
    EXPECT_EQ(node::childIndex(word, 2), 11u);
    EXPECT_EQ(node::childIndex(word, 5), 12u);
    EXPECT_EQ(node::childIndex(word, 7), 13u);
}

TEST(Octant, HasZInTheHighBit) {
    EXPECT_EQ(octantOf({1, 0, 0}, 0), 1u);
    EXPECT_EQ(octantOf({0, 1, 0}, 0), 2u);
    EXPECT_EQ(octantOf({0, 0, 1}, 0), 4u);
    EXPECT_EQ(octantOf({8, 0, 8}, 3), 5u);
    EXPECT_EQ(octantOf({8, 0, 8}, 2), 0u);
    for (unsigned octant = 0; octant < 8; ++octant) {
        EXPECT_EQ(octantOf(octantCorner(octant), 0), octant);
    }
}

TEST(DepthForSize, IsTheCeilingOfTheLogarithmAndAtLeastOne) {
    EXPECT_EQ(depthForSize({0, 0, 0}), 1);
    EXPECT_EQ(depthForSize({1, 1, 1}), 1);
    EXPECT_EQ(depthForSize({2, 1, 1}), 1);
    EXPECT_EQ(depthForSize({1, 3, 1}), 2);
    EXPECT_EQ(depthForSize({1, 1, 4}), 2);
    EXPECT_EQ(depthForSize({5, 4, 4}), 3);
    EXPECT_EQ(depthForSize({256, 1, 1}), 8);
    EXPECT_EQ(depthForSize({257, 1, 1}), 9);
    EXPECT_EQ(depthForSize({65536, 1, 1}), 16);
}

TEST(MaterialAt, IsEmptyOutsideTheSizeAndTheRoot) {
    const std::vector<std::uint32_t> nodes{7};  // a 4-cube of material 7
    OctreeView view{nodes, {}, 2, {4, 4, 4}, {0, 0, 0}};
    EXPECT_EQ(materialAt(view, {0, 0, 0}), 7);
    EXPECT_EQ(materialAt(view, {3, 3, 3}), 7);
    EXPECT_EQ(materialAt(view, {4, 0, 0}), 0);
    EXPECT_EQ(materialAt(view, {0, -1, 0}), 0);

    view.size = {10, 4, 4};  // the bounds are wider than the root
    view.treeFromVoxel = {-3, 0, 0};
    EXPECT_EQ(materialAt(view, {2, 0, 0}), 0);
    EXPECT_EQ(materialAt(view, {3, 0, 0}), 7);
    EXPECT_EQ(materialAt(view, {6, 0, 0}), 7);
    EXPECT_EQ(materialAt(view, {7, 0, 0}), 0);
}

TEST(SolidCount, CountsUniformCubesAndBricks) {
    const std::vector<std::uint32_t> nodes{0x8000'0103, 5, 0x8000'0301, 0x4000'0000};
    const std::vector<std::uint64_t> payloads{0x0100'0000'0000'FF02};
    EXPECT_EQ(solidCount({nodes, payloads, 3, {8, 4, 4}, {0, 0, 0}}), 64u + 3u);
    const std::vector<std::uint32_t> empty{0};
    EXPECT_EQ(solidCount({empty, {}, 4, {16, 16, 16}, {0, 0, 0}}), 0u);
    const std::vector<std::uint32_t> vast{9};
    EXPECT_EQ(solidCount({vast, {}, 16, glm::ivec3(65536), {0, 0, 0}}), std::uint64_t{1} << 48);
}

}  // namespace
}  // namespace voxprite
