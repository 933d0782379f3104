#include "core/edit/reshape.h"

#include <gtest/gtest.h>

#include "core/edit/shapes.h"
#include "tests/support/positions.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::mapOf;
using test::Random;
using test::VoxelMap;

VoxelGrid afterPatch(const Document& document, const VoxelPatch& patch) {
    VoxelGrid voxels = document.models[0].voxels;
    for (const VoxelChange& change : patch.changes) {
        EXPECT_EQ(voxels.get(change.position), change.before);
        EXPECT_NE(change.after, change.before);
        voxels.set(change.position, change.after);
    }
    return voxels;
}

// As recorded steps have them.
void expectAscending(const VoxelPatch& patch) {
    const auto isBefore = [](const VoxelChange& a, const VoxelChange& b) {
        return test::key(a.position) < test::key(b.position);
    };
    for (std::size_t i = 1; i < patch.changes.size(); ++i) {
        ASSERT_TRUE(isBefore(patch.changes[i - 1], patch.changes[i]));
    }
}

TEST(Reshape, SetsOfVoxelsChangeAsTheModeSays) {
    Random random(92);
    for (int round = 0; round < 60; ++round) {
        VoxelGrid before = test::randomVoxels(random.next(), {20, 20, 20}, 0.4, 5);
        if (round % 4 == 0) before.fill({{0, 0, 0}, {64, 64, 8}}, 2);
        const Document document = test::documentOf(before);
        VoxelSet set = shapeVoxels({static_cast<ShapeKind>(round % 3),
                                    IBox::around(random.voxel(-5, 25), random.voxel(-5, 25)),
                                    random.between(0, 2), round % 2 == 0})
                           .value();
        if (round % 5 == 0) set.insert(IBox{{-64, -64, 0}, {64, 64, 1}});
        const auto mode = static_cast<EditMode>(round % 3);
        const VoxelSet only(IBox::around(random.voxel(-5, 25), random.voxel(-5, 25)));
        const EditLimits limits{std::nullopt, round % 7 < 4 ? nullptr : &only};
        VoxelMap expected = mapOf(before);
        set.forEach([&](glm::ivec3 v) {
            if (!limits.allow(v)) return;
            const bool solid = before.get(v) != 0;
            if (mode == EditMode::erase) expected.erase({v.x, v.y, v.z});
            if ((mode == EditMode::attach && !solid) || (mode == EditMode::paint && solid)) {
                expected[{v.x, v.y, v.z}] = 4;
            }
        });
        const VoxelPatch patch = patchSet(document, 0, set, mode, 4, limits).value();
        expectAscending(patch);
        ASSERT_EQ(mapOf(afterPatch(document, patch)), expected);
    }
}

TEST(Reshape, HugeEditsAreRefused) {
    const Document document = test::documentOf(test::solidBox({2, 2, 2}));
    const auto tooLarge =
        patchSet(document, 0, VoxelSet(IBox{{0, 0, 0}, {512, 512, 512}}), EditMode::attach, 1);
    ASSERT_FALSE(tooLarge);
    EXPECT_EQ(tooLarge.error().message,
              "The edit is too large: it would change 134217720 voxels; at most 33554432 voxels "
              "change at once");
    const VoxelSet everything(IBox{glm::ivec3(-4096), glm::ivec3(4096)});
    EXPECT_FALSE(patchSet(document, 0, everything, EditMode::attach, 1));
    // What is not there costs nothing.
    EXPECT_EQ(patchSet(document, 0, everything, EditMode::erase, 0).value().changes.size(), 8u);
    EXPECT_EQ(patchSet(document, 0, everything, EditMode::paint, 9).value().changes.size(), 8u);
}

TEST(Reshape, CropsToWhatIsKept) {
    const Document document = test::documentOf(test::randomVoxels(3, {12, 12, 12}, 0.5, 4));
    const IBox half{{0, 0, 0}, {6, 12, 12}};
    VoxelMap cropped;
    document.models[0].voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        if (half.contains(v)) cropped[{v.x, v.y, v.z}] = value;
    });
    const VoxelPatch patch = patchCrop(document, 0, VoxelSet(half)).value();
    EXPECT_EQ(mapOf(afterPatch(document, patch)), cropped);
}

TEST(Reshape, MovesToTheMiddleAndToTheGround) {
    const IBox bounds{{5, -3, 7}, {10, 1, 9}};  // 5 x 4 x 2
    EXPECT_EQ(bounds.min + offsetToCentre(bounds), glm::ivec3(-2, -2, 7));
    EXPECT_EQ(bounds.min + offsetToGround(bounds), glm::ivec3(5, -3, 0));
    EXPECT_EQ(offsetToCentre(IBox{}), glm::ivec3(0));
    EXPECT_EQ(offsetToGround(IBox{}), glm::ivec3(0));
}

}  // namespace
}  // namespace voxprite
