#include "core/edit/patches.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::mapOf;
using test::Random;
using test::VoxelMap;

// The rule of each mode, voxel by voxel.
std::uint8_t expectedAfter(std::uint8_t before, EditMode mode, std::uint8_t value) {
    if (mode == EditMode::erase) return 0;
    const bool applies = (mode == EditMode::attach) == (before == 0);
    return applies ? value : before;
}

void applyTo(Document& document, const VoxelPatch& patch) {
    VoxelGrid& voxels = document.models[static_cast<std::size_t>(patch.model)].voxels;
    for (const VoxelChange& change : patch.changes) {
        ASSERT_EQ(voxels.get(change.position), change.before);
        ASSERT_NE(change.before, change.after);
        voxels.set(change.position, change.after);
    }
}

TEST(Patches, BoxesChangeWhatTheModeSays) {
    Random random(41);
    for (int round = 0; round < 60; ++round) {
        Document document =
            test::documentOf(test::randomVoxels(random.next(), {12, 12, 12}, 0.5, 4));
        const VoxelGrid before = document.models[0].voxels;
        const IBox box = IBox::around(random.voxel(-3, 14), random.voxel(-3, 14));
        const auto mode = static_cast<EditMode>(round % 3);
        const auto value = static_cast<std::uint8_t>(random.between(1, 4));
        applyTo(document, patchBox(document, 0, box, mode, value));
        for (int i = 0; i < 20 * 20 * 20; ++i) {
            const glm::ivec3 v(i % 20 - 4, i / 20 % 20 - 4, i / 400 - 4);
            const std::uint8_t expected =
                box.contains(v) ? expectedAfter(before.get(v), mode, value) : before.get(v);
            ASSERT_EQ(document.models[0].voxels.get(v), expected);
        }
    }
}

TEST(Patches, SingleVoxelsMayBeNamedTwice) {
    Random random(42);
    for (const EditMode mode : {EditMode::attach, EditMode::erase, EditMode::paint}) {
        Document document = test::documentOf(test::randomVoxels(9, {8, 8, 8}, 0.5, 4));
        const VoxelGrid before = document.models[0].voxels;
        std::vector<glm::ivec3> positions;
        for (int i = 0; i < 300; ++i) positions.push_back(random.voxel(-2, 9));
        VoxelMap expected = mapOf(before);
        for (const glm::ivec3 v : positions) {
            const std::uint8_t after = expectedAfter(before.get(v), mode, 3);
            if (after == 0) {
                expected.erase({v.x, v.y, v.z});
            } else {
                expected[{v.x, v.y, v.z}] = after;
            }
        }
        applyTo(document, patchVoxels(document, 0, positions, mode, 3));
        EXPECT_EQ(mapOf(document.models[0].voxels), expected);
    }
}

TEST(Patches, HoldOnlyWhatChanges) {
    const Document document = test::documentOf(test::solidBox({2, 1, 1}, 5));
    const std::vector<glm::ivec3> all{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    const auto changes = [&](EditMode mode, std::uint8_t value) {
        return patchVoxels(document, 0, all, mode, value).changes;
    };
    EXPECT_EQ(changes(EditMode::attach, 9), (std::vector<VoxelChange>{{{2, 0, 0}, 0, 9}}));
    EXPECT_EQ(changes(EditMode::paint, 5), std::vector<VoxelChange>{});
    EXPECT_EQ(changes(EditMode::paint, 6),
              (std::vector<VoxelChange>{{{0, 0, 0}, 5, 6}, {{1, 0, 0}, 5, 6}}));
    EXPECT_EQ(changes(EditMode::erase, 0),
              (std::vector<VoxelChange>{{{0, 0, 0}, 5, 0}, {{1, 0, 0}, 5, 0}}));
    EXPECT_EQ(patchBox(document, 0, {{1, 0, 0}, {3, 1, 1}}, EditMode::attach, 9).changes,
              (std::vector<VoxelChange>{{{2, 0, 0}, 0, 9}}));
}

TEST(Patches, ErasingAndPaintingHugeBoxesCostsOnlyWhatIsSolid) {
    Document document = test::documentOf(test::figure());
    const std::uint64_t solid = document.models[0].voxels.solidCount();
    document.models[0].voxels.set({kMaxCoordinate, 0, 0}, 1);
    // Visiting these 10^22 positions would not end.
    const IBox everywhere{glm::ivec3(-kMaxCoordinate), glm::ivec3(kMaxCoordinate + 1)};
    EXPECT_EQ(patchBox(document, 0, everywhere, EditMode::erase, 0).changes.size(), solid + 1);
    EXPECT_EQ(patchBox(document, 0, everywhere, EditMode::paint, 250).changes.size(), solid + 1);
}

TEST(Patches, WhatLiesBeyondTheCoordinatesIsLeftAlone) {
    const Document document = Document::withEmptyModel();
    const std::vector<glm::ivec3> positions{{kMaxCoordinate + 1, 0, 0}, {kMaxCoordinate, 0, 0}};
    EXPECT_EQ(patchVoxels(document, 0, positions, EditMode::attach, 1).changes,
              (std::vector<VoxelChange>{{{kMaxCoordinate, 0, 0}, 0, 1}}));
    const IBox across{{kMaxCoordinate - 1, 0, 0}, {kMaxCoordinate + 9, 1, 1}};
    EXPECT_EQ(patchBox(document, 0, across, EditMode::attach, 1).changes.size(), 2u);
}

}  // namespace
}  // namespace voxprite
