// The brush, the picking tools and what holds for all tools: what the pointer does to the voxels,
// without a window.
#include <cmath>

#include "core/edit/scene_edits.h"
#include "tests/app/tool_hand.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

// A plate of 40 x 40 x 1 voxels, seen from above.
class ToolsOnAPlate : public test::ToolHand {
  protected:
    ToolsOnAPlate() {
        attachBox({{-20, -20, 0}, {20, 20, 1}}, 5);
        orbit.yawDegrees = 25.0;
        orbit.pitchDegrees = 55.0;
        orbit.target = worldFromVoxel({0, 0, 1});
        orbit.distance = 60.0;
        settings.colour = 9;
    }
    [[nodiscard]] const VoxelGrid& voxels() const { return session.document().models[0].voxels; }
};

TEST_F(ToolsOnAPlate, PicksTheFaceUnderThePointer) {
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
        const glm::ivec3 voxel(random.between(-19, 18), random.between(-19, 18), 0);
        const auto found = pickAt(faceOf(voxel));
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->voxel, voxel);
        EXPECT_EQ(found->normal, glm::ivec3(0, 0, 1));
        EXPECT_FALSE(found->ground);
    }
}

TEST_F(ToolsOnAPlate, AttachedLineHasNoGapAndOneLayer) {
    drag({faceOf({-15, -9, 0}), faceOf({15, 12, 0})});
    EXPECT_EQ(voxels().get({-15, -9, 1}), 9);
    EXPECT_EQ(voxels().get({15, 12, 1}), 9);
    EXPECT_EQ(session.bounds().max.z, 2);
    // Every column that the line crosses, each voxel touching the one before.
    for (int x = -15; x < 15; ++x) {
        bool touches = false;
        for (int y = -20; y < 20; ++y) {
            for (int next = y - 1; next <= y + 1; ++next) {
                touches = touches ||
                          (voxels().get({x, y, 1}) == 9 && voxels().get({x + 1, next, 1}) == 9);
            }
        }
        EXPECT_TRUE(touches) << "gap after x = " << x;
    }
}

TEST_F(ToolsOnAPlate, ScribblingOnOnePlaceNeverClimbs) {
    std::vector<glm::dvec2> path;
    for (int i = 0; i < 60; ++i) path.push_back(faceOf({i % 2, (i / 2) % 2, 0}));
    drag(path);
    EXPECT_EQ(session.bounds().max.z, 2);
    EXPECT_EQ(voxels().solidCount(), 1600u + 4u);
}

TEST_F(ToolsOnAPlate, ErasingDigsOneLayer) {
    attachBox({{-20, -20, -5}, {20, 20, 0}}, 6);
    settings.mode = EditMode::erase;
    std::vector<glm::dvec2> path;
    for (int i = 0; i < 40; ++i) path.push_back(faceOf({i % 2, 0, 0}));
    const std::uint64_t before = voxels().solidCount();
    drag(path);
    EXPECT_EQ(voxels().solidCount(), before - 2);
    EXPECT_EQ(voxels().get({0, 0, -1}), 6);
}

TEST_F(ToolsOnAPlate, OneStrokeIsOneStepAndIsMadeWhenTheButtonGoesUp) {
    const std::size_t before = session.history().position();
    const VoxelGrid start = made();
    settings.mode = EditMode::paint;
    moveTo(faceOf({-9, 0, 0}));
    press();
    for (const int x : {-3, 4, 9}) moveTo(faceOf({x, 0, 0}));
    EXPECT_EQ(made(), start);
    EXPECT_EQ(shown().get({-9, 0, 0}), 9);
    EXPECT_EQ(shown().get({9, 0, 0}), 9);
    release();
    EXPECT_EQ(session.history().position(), before + 1);
    EXPECT_EQ(shown(), made());
    EXPECT_EQ(voxels().get({-9, 0, 0}), 9);
    EXPECT_EQ(voxels().solidCount(), 1600u);
    click(faceOf({0, 5, 0}));
    EXPECT_EQ(session.history().position(), before + 2);
    ASSERT_TRUE(session.undo());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(made(), start);
}

TEST_F(ToolsOnAPlate, WhatTheClickWillDoIsShownBeforeIt) {
    for (const EditMode mode : {EditMode::attach, EditMode::erase, EditMode::paint}) {
        settings.mode = mode;
        settings.options.tipEdge = 3;
        const VoxelGrid before = made();
        moveTo(faceOf({-8, -8, 0}));
        moveTo(faceOf({2, 3, 0}));
        EXPECT_EQ(made(), before);
        const VoxelGrid coming = shown();
        EXPECT_NE(coming, before);
        press();
        release();
        EXPECT_EQ(made(), coming);
        // At rest what was made is shown, and not what another click would do.
        EXPECT_EQ(shown(), coming);
        moveTo(pointer + 1.0);
        EXPECT_EQ(shown(), coming);
        ASSERT_TRUE(session.undo());
        EXPECT_EQ(shown(), before);
    }
}

TEST_F(ToolsOnAPlate, ShiftSwapsAttachAndErase) {
    shift = true;
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(voxels().solidCount(), 1599u);
    settings.mode = EditMode::erase;
    click(faceOf({3, 0, 0}));
    EXPECT_EQ(voxels().get({3, 0, 1}), 9);
    settings.mode = EditMode::paint;
    click(faceOf({6, 0, 0}));
    EXPECT_EQ(voxels().get({6, 0, 0}), 9);
}

TEST_F(ToolsOnAPlate, AltPicksAColourAndEditsNothing) {
    attachBox({{2, 2, 1}, {3, 3, 2}}, 77);
    const VoxelGrid before = made();
    alt = true;
    click(faceOf({2, 2, 1}));
    EXPECT_EQ(settings.colour, 77);
    EXPECT_EQ(made(), before);
    EXPECT_EQ(shown(), before);
    click({5, 5});  // beside the model
    EXPECT_EQ(settings.colour, 77);
}

TEST_F(ToolsOnAPlate, PickingToolsAreGoodForOneClick) {
    settings.choose(ToolKind::pickColour);
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(settings.colour, 5);
    EXPECT_EQ(settings.tool, ToolKind::brush);
    settings.choose(ToolKind::anchor);
    click(faceOf({4, -3, 0}));
    EXPECT_EQ(session.document().entity.anchorVoxels, glm::dvec3(4.5, -2.5, 0.5));
    settings.choose(ToolKind::anchor);
    shift = true;
    click(faceOf({4, -3, 0}));
    EXPECT_EQ(session.document().entity.anchorVoxels, glm::dvec3(4.5, -2.5, 1.0));
}

TEST_F(ToolsOnAPlate, CubesStandOnTheFaceAndBiteFromIt) {
    attachBox({{-20, -20, -9}, {20, 20, 0}}, 6);
    for (const int edge : {2, 3, 8}) {
        settings.options.tipEdge = edge;
        settings.mode = EditMode::attach;
        const VoxelGrid before = made();
        click(faceOf({0, 0, 0}));
        VoxelGrid grown = made();
        EXPECT_EQ(grown.solidCount(), before.solidCount() + std::uint64_t(edge * edge * edge));
        EXPECT_EQ(session.bounds().max.z, 1 + edge);
        ASSERT_TRUE(session.undo());
        settings.mode = EditMode::erase;
        click(faceOf({0, 0, 0}));
        EXPECT_EQ(made().solidCount(), before.solidCount() - std::uint64_t(edge * edge * edge));
        EXPECT_EQ(made().get({0, 0, 1 - edge}), 0);
        EXPECT_NE(made().get({0, 0, -edge}), 0);
        ASSERT_TRUE(session.undo());
    }
}

TEST_F(ToolsOnAPlate, DiscsLieFlatInTheFace) {
    attachBox({{-20, -20, -20}, {20, 20, 0}}, 6);
    settings.options.tip = TipShape::disc;
    settings.options.tipEdge = 7;
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(session.bounds(), (IBox{{-20, -20, -20}, {20, 20, 2}}));
    EXPECT_EQ(made().get({3, 0, 1}), 9);
    EXPECT_EQ(made().get({3, 3, 1}), 0);  // round
    ASSERT_TRUE(session.undo());
    // On the side that faces the eye it stands upright.
    click(faceOf({0, -20, -8}, {0, -1, 0}));
    EXPECT_EQ(session.bounds(), (IBox{{-20, -21, -20}, {20, 20, 1}}));
    EXPECT_EQ(made().get({3, -21, -8}), 9);
    EXPECT_EQ(made().get({0, -21, -5}), 9);
    EXPECT_EQ(made().get({0, -22, -8}), 0);
}

TEST_F(ToolsOnAPlate, SpheresFillWhatLiesWithinTheirRadius) {
    attachBox({{-20, -20, -20}, {20, 20, 0}}, 6);
    settings.options.tip = TipShape::sphere;
    settings.options.tipEdge = 9;
    settings.mode = EditMode::erase;
    VoxelGrid expected = made();
    click(faceOf({1, 2, 0}));
    for (int x = -5; x <= 5; ++x) {
        for (int y = -5; y <= 5; ++y) {
            for (int z = -5; z <= 5; ++z) {
                if (4 * (x * x + y * y + z * z) <= 81) expected.set({1 + x, 2 + y, z}, 0);
            }
        }
    }
    EXPECT_EQ(made(), expected);
}

TEST_F(ToolsOnAPlate, AStrokeThatBeginsOnTheGroundNeverGoesBelowIt) {
    ASSERT_TRUE(session.startNew());
    settings.options.tip = TipShape::sphere;
    settings.options.tipEdge = 11;
    drag({faceOf({-4, 0, -1}), faceOf({6, 3, -1})});
    EXPECT_EQ(session.bounds().min.z, 0);
    EXPECT_EQ(session.bounds().max.z, 6);
}

TEST_F(ToolsOnAPlate, MirrorsAndLimitsHoldForStrokes) {
    settings.options.symmetry.on = {true, true, false};
    settings.options.symmetry.planeDoubled = {0, 1, 0};  // between voxels in x, through one in y
    settings.options.limited = true;
    settings.options.limits = {{-12, -12, -5}, {7, 12, 5}};
    drag({faceOf({3, 4, 0}), faceOf({12, 4, 0})});
    VoxelGrid expected = flatten(session.document(), 0);
    std::uint64_t count = 0;
    expected.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        if (value != 9) return;
        ++count;
        EXPECT_LT(v.x, 7);
        for (const glm::ivec3 image : {glm::ivec3(-1 - v.x, v.y, 1), glm::ivec3(v.x, -v.y, 1)}) {
            if (settings.options.limits.contains(image)) {
                EXPECT_EQ(expected.get(image), 9);
            }
        }
    });
    // x 3...6 within the limits and -4...-12 of x 3...12, in the rows y 4 and -4.
    EXPECT_EQ(count, 2u * (4u + 9u));
}

TEST_F(ToolsOnAPlate, EscapeDropsAStroke) {
    const VoxelGrid before = made();
    moveTo(faceOf({0, 0, 0}));
    press();
    moveTo(faceOf({9, 0, 0}));
    EXPECT_NE(shown(), before);
    tools.cancel(session);
    EXPECT_EQ(shown(), before);
    release();
    EXPECT_EQ(made(), before);
}

TEST_F(ToolsOnAPlate, AttachesThroughATurnedAndMirroredObject) {
    // The same plate, its object turned upside down and mirrored: entity space decides.
    SceneEdit edit{sceneOf(session.document()), sceneOf(session.document()), 1, {}};
    edit.after.nodes[1].placements[0].placement = {{{1, 0, 2}, {1, -1, -1}}, {3, 0, 5}};
    ASSERT_TRUE(session.perform(makeAction("turn", edit)));
    const glm::ivec3 top(7, -3, session.bounds().max.z - 1);
    settings.options.tipEdge = 2;  // an even tip is not its own mirror image
    const VoxelGrid before = made();
    settings.options.symmetry.on = {true, false, false};
    settings.options.symmetry.planeDoubled = {1, 0, 0};
    click(faceOf(top));
    VoxelGrid expected = before;
    for (int x = 0; x < 2; ++x) {
        for (int y = 0; y < 2; ++y) {
            for (int z = 0; z < 2; ++z) {
                const glm::ivec3 v = top + glm::ivec3(x, y, 1 + z);
                expected.set(v, 9);
                expected.set({-v.x, v.y, v.z}, 9);
            }
        }
    }
    EXPECT_EQ(made(), expected);
    EXPECT_EQ(shown(), expected);
}

TEST_F(ToolsOnAPlate, ErasingTakesTheObjectThatWasHit) {
    ASSERT_TRUE(session.perform(addObject(session.document(), "hat")));
    session.setActiveNode(2);
    const std::vector<glm::ivec3> hat{{0, 0, 1}, {1, 0, 1}};
    ASSERT_TRUE(session.perform(
        makeAction("hat", patchVoxels(session.document(), 1, hat, EditMode::attach, 8))));
    settings.mode = EditMode::erase;
    // From the hat onto the plate: only the hat is touched.
    drag({faceOf({0, 0, 1}), faceOf({8, 0, 0})});
    EXPECT_EQ(session.document().models[1].voxels.solidCount(), 0u);
    EXPECT_EQ(voxels().solidCount(), 1600u);
    EXPECT_EQ(session.activeNode(), 2);
    click(faceOf({8, 0, 0}));
    EXPECT_EQ(session.activeNode(), 1);
    EXPECT_EQ(voxels().solidCount(), 1599u);
}

TEST_F(ToolsOnAPlate, LockedAndHiddenObjectsAreRefusedByName) {
    ASSERT_TRUE(session.perform(rename(session.document(), 1, "plate")));
    ASSERT_TRUE(session.perform(setLocked(session.document(), 1, true)));
    const VoxelGrid before = made();
    moveTo(faceOf({0, 0, 0}));
    EXPECT_EQ(refusal, "");  // only who clicks is told
    press();
    EXPECT_NE(refusal.find("plate"), std::string::npos);
    release();
    EXPECT_EQ(made(), before);
    EXPECT_EQ(shown(), before);
    ASSERT_TRUE(session.perform(setLocked(session.document(), 1, false)));
    ASSERT_TRUE(session.perform(setHidden(session.document(), 1, true)));
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(session.document().models[0].voxels.solidCount(), 1600u);
}

TEST(EditorPicking, EmptyModelIsStartedOnTheGround) {
    const Session session;
    OrbitCamera orbit;
    orbit.distance = 30.0;
    orbit.pitchDegrees = 40.0;
    const Camera camera = orbit.camera({640, 480});
    const glm::dvec2 px = camera.project(worldFromVoxel({3.5, -2.5, 0.0})).screenPx;
    const auto found = pick(session.octree(), session.bounds(), camera.rayThrough(px));
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->ground);
    EXPECT_EQ(found->attachTo(), glm::ivec3(3, -3, 0));
    // Above the horizon there is nothing; nor is there from below.
    EXPECT_FALSE(pick(session.octree(), session.bounds(), camera.rayThrough({320, -900})));
    orbit.pitchDegrees = -40.0;
    EXPECT_FALSE(
        pick(session.octree(), session.bounds(), orbit.camera({640, 480}).rayThrough({320, 240})));
}

TEST(EditorPicking, FaceCornersLieOnTheFace) {
    test::Random random(8);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            Pick face;
            face.voxel = random.voxel(-50, 50);
            face.normal = glm::ivec3(0);
            face.normal[axis] = sign;
            const glm::dvec3 centre = glm::dvec3(face.voxel) + 0.5 + glm::dvec3(face.normal) * 0.5;
            glm::dvec3 sum(0.0);
            for (const glm::dvec3 corner : faceCorners(face)) {
                EXPECT_EQ(corner[axis], centre[axis]);
                sum += corner;
            }
            EXPECT_EQ(sum / 4.0, centre);
        }
    }
}

}  // namespace
}  // namespace voxprite::editor
