#include "core/edit/clip.h"

#include <gtest/gtest.h>

#include "core/edit/selection.h"
#include "core/edit/transforms.h"
#include "tests/support/edits.h"
#include "tests/support/positions.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::afterPatch;
using test::forEachVoxel;
using test::mapOf;
using test::Random;
using test::VoxelMap;

VoxelClip wholeClip(const VoxelGrid& voxels) {
    return copyVoxels(voxels, selectAll(voxels));
}

TEST(Clip, CopiesWhatIsSelectedAndSolid) {
    Random random(61);
    for (int round = 0; round < 20; ++round) {
        VoxelGrid voxels = test::randomVoxels(random.next(), {20, 20, 20}, 0.3, 9);
        if (round % 2 == 0) voxels.fill({{64, 64, 0}, {128, 128, 64}}, 4);
        VoxelSet selection(IBox::around(random.voxel(-5, 100), random.voxel(-5, 100)));
        for (int i = 0; i < 50; ++i) selection.insert(random.voxel(0, 70));
        VoxelMap expected;
        voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            if (selection.contains(v)) expected[{v.x, v.y, v.z}] = value;
        });
        const VoxelClip clip = copyVoxels(voxels, selection);
        ASSERT_EQ(mapOf(clip.voxels), expected);
        ASSERT_EQ(clip.placed(), clip.voxels);
        ASSERT_EQ(clip.footprint().count(), expected.size());
    }
}

TEST(Clip, PastesOverAndUnder) {
    Random random(62);
    for (int round = 0; round < 40; ++round) {
        const Document document =
            test::documentOf(test::randomVoxels(random.next(), {12, 12, 12}, 0.4, 9));
        VoxelClip clip = wholeClip(test::randomVoxels(random.next(), {5, 6, 7}, 0.5, 9));
        moveBy(clip, random.voxel(-4, 10));
        turn(clip, random.between(0, 2), random.between(0, 3));
        const auto rule = round % 2 == 0 ? PasteRule::over : PasteRule::under;
        EditLimits limits;
        if (round % 3 == 0) limits.box = IBox{{0, 0, 0}, {8, 12, 12}};
        VoxelMap expected = mapOf(document.models[0].voxels);
        clip.placed().forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            if (!limits.allow(v)) return;
            if (rule == PasteRule::over) {
                expected[{v.x, v.y, v.z}] = value;
            } else {
                expected.try_emplace({v.x, v.y, v.z}, value);
            }
        });
        const VoxelPatch patch = patchPaste(document, 0, clip, rule, limits).value();
        ASSERT_EQ(afterPatch(document, patch), expected);
    }
}

TEST(Clip, MovingLosesNothingOnTheWay) {
    // A selection is dragged over other voxels and back: what it passed over is untouched.
    const Document document = test::documentOf(test::randomVoxels(7, {16, 16, 16}, 0.5, 9));
    const VoxelSet from = selectBox(document.models[0].voxels, {{0, 0, 0}, {5, 5, 5}});
    VoxelClip clip = copyVoxels(document.models[0].voxels, from);
    moveBy(clip, {6, 6, 6});
    VoxelMap expected = mapOf(document.models[0].voxels);
    from.forEach([&](glm::ivec3 v) { expected.erase({v.x, v.y, v.z}); });
    clip.placed().forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        expected[{v.x, v.y, v.z}] = value;
    });
    EXPECT_EQ(afterPatch(document, patchMove(document, 0, from, clip).value()), expected);
    moveBy(clip, {-6, -6, -6});
    EXPECT_TRUE(patchMove(document, 0, from, clip).value().changes.empty());
}

TEST(Clip, OutOfRangeIsAnError) {
    const Document document = test::documentOf(test::solidBox({2, 2, 2}));
    VoxelClip clip = wholeClip(document.models[0].voxels);
    moveBy(clip, {kMaxCoordinate, 0, 0});
    EXPECT_FALSE(patchPaste(document, 0, clip));
    EXPECT_FALSE(scale(clip, 2));
}

// The turn as a person would compute it, on continuous coordinates about the centre of a cube.
TEST(Transforms, QuarterTurnsAreCounterClockwise) {
    const VoxelGrid voxels = test::randomVoxels(8, {9, 9, 9}, 0.3, 9);
    for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3;
        const int b = (axis + 2) % 3;
        VoxelMap expected;
        voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            glm::ivec3 to = v;
            to[a] = 4 - (v[b] - 4);
            to[b] = 4 + (v[a] - 4);
            expected[{to.x, to.y, to.z}] = value;
        });
        const Placement placement = inPlace(quarterTurns(axis, 1), {{0, 0, 0}, {9, 9, 9}});
        EXPECT_EQ(mapOf(transformed(voxels, placement)), expected);
    }
}

TEST(Transforms, FourTurnsAndTwoFlipsAreNothing) {
    Random random(63);
    for (int round = 0; round < 60; ++round) {
        VoxelClip clip;
        // Odd, even and mixed sizes.
        clip.voxels.fill({{0, 0, 0}, random.voxel(1, 9)}, 1);
        clip.voxels.set({0, 0, 0}, 2);
        moveBy(clip, random.voxel(-20, 20));
        const VoxelGrid start = clip.placed();
        const IBox box = clip.bounds();
        const int axis = round % 3;
        for (int i = 0; i < 4; ++i) {
            turn(clip, axis, 1);
            // It stays where it was: the centre moves by half a voxel at most.
            const glm::ivec3 drift = clip.bounds().min + clip.bounds().max - box.min - box.max;
            for (int k = 0; k < 3; ++k) ASSERT_LE(std::abs(drift[k]), 1);
        }
        ASSERT_EQ(clip.placed(), start);
        flip(clip, axis);
        ASSERT_EQ(clip.bounds(), box);
        flip(clip, axis);
        ASSERT_EQ(clip.placed(), start);
        // One back is three forth; two halves are flips of the other two axes.
        VoxelClip back = clip;
        turn(back, axis, -1);
        turn(clip, axis, 3);
        ASSERT_EQ(back, clip);
        turn(clip, axis, 3);
        VoxelClip flipped = clip;
        turn(flipped, axis, 2);
        flip(clip, (axis + 1) % 3);
        flip(clip, (axis + 2) % 3);
        ASSERT_EQ(flipped.placed(), clip.placed());
    }
}

TEST(Transforms, LargeBlocksStayWhole) {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {512, 512, 512}}, 3);
    const VoxelGrid moved = transformed(voxels, {flip(0), {512, 0, 0}});
    EXPECT_EQ(moved, voxels);
    EXPECT_LT(moved.bytes(), 200'000u);
}

TEST(Transforms, ScalesByWholeNumbers) {
    Random random(64);
    for (int round = 0; round < 10; ++round) {
        VoxelClip clip = wholeClip(test::randomVoxels(random.next(), {6, 7, 5}, 0.4, 9));
        turn(clip, 0, 1);
        moveBy(clip, random.voxel(-9, 9));
        const VoxelGrid before = clip.placed();
        const IBox box = before.bounds();
        const int factor = random.between(1, 4);
        ASSERT_TRUE(scale(clip, factor));
        const VoxelGrid after = clip.placed();
        EXPECT_EQ(after.solidCount(),
                  before.solidCount() * static_cast<std::uint64_t>(factor * factor * factor));
        forEachVoxel({box.min, box.min + box.size() * factor}, [&](glm::ivec3 v) {
            ASSERT_EQ(after.get(v), before.get(box.min + (v - box.min) / factor));
        });
    }
    VoxelClip solid = wholeClip(test::solidBox({100, 100, 100}));
    EXPECT_FALSE(scale(solid, 4));
    EXPECT_FALSE(scale(solid, 0));
    EXPECT_EQ(solid, wholeClip(test::solidBox({100, 100, 100})));  // as it was
}

}  // namespace
}  // namespace voxprite
