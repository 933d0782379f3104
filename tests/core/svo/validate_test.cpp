#include "core/svo/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/svo/bake.h"
#include "tests/core/svo/reference_octree.h"

namespace voxprite {
namespace {

using testing::HasSubstr;

// A 6-voxel model: root with octants 0 and 1; node 1 is uniform, node 2 internal with one brick.
Octree sample() {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {4, 4, 4}}, 5);
    voxels.set({5, 0, 0}, 7);
    Octree octree = bake(voxels).value();
    EXPECT_EQ(octree.nodes, (std::vector<std::uint32_t>{0x8000'0103, 5, 0x8000'0301, 0x4000'0000}));
    EXPECT_EQ(octree.maxDepth, 3);
    EXPECT_EQ(octree.size, glm::ivec3(6, 4, 4));
    return octree;
}

// Both validators refuse it, with this reason, at this node.
void expectUnsafe(const Octree& octree, const char* reason, std::optional<std::uint64_t> node) {
    for (const Status& status : {validateOctree(octree.view()), validateCanonical(octree)}) {
        ASSERT_FALSE(status.has_value()) << reason;
        EXPECT_THAT(status.error().message, HasSubstr(reason));
        EXPECT_EQ(status.error().offset, node);
    }
}

// It can be traversed safely, but is not what bake() writes.
void expectNotCanonical(const Octree& octree, const char* reason) {
    const Status safe = validateOctree(octree.view());
    EXPECT_TRUE(safe.has_value()) << safe.error().message;
    const Status canonical = validateCanonical(octree);
    ASSERT_FALSE(canonical.has_value()) << reason;
    EXPECT_THAT(canonical.error().message, HasSubstr(reason));
}

TEST(Validate, AcceptsTheSample) {
    EXPECT_TRUE(validateCanonical(sample()));
}

TEST(Validate, RefusesImpossibleHeads) {
    Octree octree = sample();
    octree.maxDepth = 0;
    expectUnsafe(octree, "depth", std::nullopt);
    octree.maxDepth = 17;
    expectUnsafe(octree, "depth", std::nullopt);
    octree = sample();
    octree.size.y = -4;
    expectUnsafe(octree, "too long", std::nullopt);
    octree.size.y = 65537;
    expectUnsafe(octree, "too long", std::nullopt);
    octree = sample();
    octree.nodes.clear();
    expectUnsafe(octree, "no root", std::nullopt);
    octree = sample();
    octree.nodes.resize(kMaxOctreeNodes + 1);
    expectUnsafe(octree, "8,388,608", std::nullopt);
}

TEST(Validate, RefusesChildrenBeyondTheEnd) {
    Octree octree = sample();
    octree.nodes[2] = 0x8000'0401;
    expectUnsafe(octree, "beyond the end", 2);
    octree.nodes[2] = 0xFFFF'FFFF;
    expectUnsafe(octree, "beyond the end", 2);
}

TEST(Validate, RefusesCyclesAndSharedNodes) {
    Octree octree = sample();
    octree.nodes[2] = 0x8000'0001;  // its child is the root
    expectUnsafe(octree, "reached twice", 0);
    octree.nodes[2] = 0x8000'0101;  // its child is its sibling
    expectUnsafe(octree, "reached twice", 1);
}

TEST(Validate, RefusesStrayBits) {
    for (int bit = 8; bit < 30; ++bit) {
        Octree octree = sample();
        octree.nodes[1] |= 1u << bit;
        expectUnsafe(octree, "stray bits", 1);
        octree.nodes[1] = 1u << bit;
        expectUnsafe(octree, "stray bits", 1);
    }
}

TEST(Validate, RefusesInternalNodesWithoutChildrenAndBelowTheLastLevel) {
    Octree octree = sample();
    octree.nodes[2] = 0x8000'0300;
    expectUnsafe(octree, "no children", 2);
    octree = sample();
    octree.nodes[3] = 0x8000'0401;
    octree.nodes.push_back(5);
    expectUnsafe(octree, "below the last level", 3);
}

TEST(Validate, RefusesBricksAboveTheLastLevelAndPayloadsBeyondTheEnd) {
    Octree octree = sample();
    octree.nodes[2] = 0x4000'0000;
    expectUnsafe(octree, "above the last level", 2);
    octree = sample();
    octree.nodes[3] = 0x4000'0001;
    expectUnsafe(octree, "payload beyond the end", 3);
}

TEST(Validate, RefusesSolidsOutsideTheSize) {
    Octree octree = sample();
    octree.size.x = 5;  // the voxel at x = 5
    expectUnsafe(octree, "outside the size", 3);
    octree = sample();
    octree.size.z = 3;  // the uniform 4-cube
    expectUnsafe(octree, "outside the size", 1);
    octree = sample();
    octree.nodes[0] = 5;
    expectUnsafe(octree, "outside the size", 0);
}

TEST(Validate, TheViewsOriginCounts) {
    const Octree octree = sample();
    OctreeView view = octree.view();
    view.treeFromVoxel = {-1, 0, 0};
    view.size = {7, 4, 4};
    EXPECT_TRUE(validateOctree(view));
    view.treeFromVoxel = {1, 0, 0};
    EXPECT_FALSE(validateOctree(view));
}

TEST(Validate, CanonicalMeansCollapsed) {
    Octree octree = sample();
    octree.payloads[0] = 0x0808'0808'0808'0808;
    octree.size = {8, 4, 4};
    expectNotCanonical(octree, "one material");
    octree.payloads[0] = 0;
    expectNotCanonical(octree, "one material");

    octree = sample();
    octree.nodes = {0x8000'0101, 0x8000'02FF, 5, 5, 5, 5, 5, 5, 5, 5};
    octree.payloads.clear();
    expectNotCanonical(octree, "not collapsed");
    octree.nodes[5] = 6;
    EXPECT_TRUE(validateCanonical(octree));

    octree = sample();
    octree.nodes[1] = 0;
    expectNotCanonical(octree, "empty but stored");
}

TEST(Validate, CanonicalMeansBreadthFirstWithoutHoles) {
    Octree octree = sample();
    octree.nodes = {0x8000'0203, 0, 5, 0x8000'0401, 0x4000'0000};
    expectNotCanonical(octree, "breadth-first");
    octree = sample();
    octree.nodes.push_back(5);
    expectNotCanonical(octree, "no parent");
    octree = sample();
    octree.payloads.push_back(5);
    expectNotCanonical(octree, "without owner");
    octree.nodes[3] = 0x4000'0001;
    expectNotCanonical(octree, "out of order");
}

TEST(Validate, CanonicalMeansNoDeeperThanTheSize) {
    Octree octree = sample();
    octree.maxDepth = 4;
    octree.size = {8, 8, 8};
    octree.nodes = {0x8000'0101, 5};
    octree.payloads.clear();
    expectNotCanonical(octree, "depth 4");

    octree = Octree{};
    octree.size = {2, 0, 2};
    expectNotCanonical(octree, "some axes only");
}

TEST(Validate, EveryWordFlipIsEitherRefusedOrAnotherCanonicalOctree) {
    std::mt19937 random(3);
    const VoxelGrid voxels = test::randomModel(random, {0, 0, 0}, 9);
    const Octree octree = bake(voxels).value();
    int refused = 0;
    for (std::size_t i = 0; i < octree.nodes.size(); ++i) {
        for (int bit = 0; bit < 32; ++bit) {
            Octree damaged = octree;
            damaged.nodes[i] ^= 1u << bit;
            if (!validateCanonical(damaged)) {
                ++refused;
                continue;
            }
            // Only a material may have changed, and the bake of its voxels gives it back.
            const IBox bounds{octree.origin, octree.origin + octree.size};
            EXPECT_EQ(bake(toVoxels(damaged), bounds).value(), damaged);
        }
    }
    EXPECT_GT(refused, static_cast<int>(octree.nodes.size()) * 20);
}

}  // namespace
}  // namespace voxprite
