// Edits of very many voxels: worked out behind the window, and the same as all others.
#include <gtest/gtest.h>

#include "app/editor/session/selection_edits.h"
#include "core/edit/scene_edits.h"
#include "core/svo/bake.h"
#include "tests/app/tool_hand.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

constexpr int kEdge = 68;  // 314,432 voxels, more than kLongStepVoxels
constexpr IBox kCube{{0, 0, 0}, {kEdge, kEdge, kEdge}};

class LargeEdits : public test::ToolHand {
  protected:
    void SetUp() override {
        ASSERT_TRUE(session.perform(
            makeAction("cube", patchBox(session.document(), 0, kCube, EditMode::attach, 5))));
        orbit.target = worldFromVoxel({32.0, 32.0, 32.0});
        orbit.yawDegrees = 30.0;
        orbit.pitchDegrees = 40.0;
        orbit.distance = 200.0;
        (void)session.takeOctreeChanges();
    }
    // Both octrees are what a bake of the document gives.
    void expectInOrder() {
        const Result<Octree> baked = bake(made(), session.bounds());
        ASSERT_TRUE(baked);
        for (const LiveOctree* live : {&session.octree(), &session.shownOctree()}) {
            const Result<Octree> canonical = live->canonical(session.bounds());
            ASSERT_TRUE(canonical);
            EXPECT_EQ(canonical->nodes, baked->nodes);
            EXPECT_EQ(canonical->payloads, baked->payloads);
        }
        EXPECT_EQ(session.bounds(), made().bounds());
    }
    void commitUndo() {
        ASSERT_TRUE(session.undoIsLong());
        auto prepared = session.prepareUndo({});
        ASSERT_TRUE(prepared);
        session.commit(std::move(**prepared));
    }
};

TEST_F(LargeEdits, AFillIsShownWhenItIsReadyAndMadeByTheClick) {
    const VoxelGrid before = made();
    settings.tool = ToolKind::fill;
    settings.colour = 9;
    moveTo(faceOf({20, 30, kEdge - 1}));
    EXPECT_FALSE(session.previews()) << "not while the hand is on its way";
    EXPECT_TRUE(tools.previewsLater());
    tools.finishPreview(session);
    EXPECT_TRUE(session.previews());
    EXPECT_EQ(session.shownOctree().at({1, 2, 3}), 9);
    EXPECT_EQ(session.octree().at({1, 2, 3}), 5);
    EXPECT_TRUE(session.takeOctreeChanges().everything);
    // Elsewhere on the same region: it stays.
    moveTo(faceOf({40, 10, kEdge - 1}));
    EXPECT_TRUE(session.previews());
    EXPECT_FALSE(tools.previewsLater());

    click(faceOf({40, 10, kEdge - 1}));
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 9));
    EXPECT_EQ(session.history().steps().back().label, "Fill");
    EXPECT_FALSE(session.previews());
    EXPECT_TRUE(session.takeOctreeChanges().everything);
    expectInOrder();

    commitUndo();
    EXPECT_EQ(made(), before);
    expectInOrder();
    ASSERT_TRUE(session.redoIsLong());
    auto prepared = session.prepareRedo({});
    ASSERT_TRUE(prepared);
    session.commit(std::move(**prepared));
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 9));
    expectInOrder();
}

TEST_F(LargeEdits, APreviewOfWhatChangedMeanwhileIsNotShown) {
    settings.tool = ToolKind::fill;
    settings.colour = 9;
    moveTo(faceOf({20, 30, kEdge - 1}));
    attachBox({{-3, 0, 0}, {-1, 1, 1}}, 2);
    tools.finishPreview(session);
    EXPECT_FALSE(session.previews());
    expectInOrder();
}

TEST_F(LargeEdits, AShapeIsOutlinedThenShownThenMade) {
    settings.tool = ToolKind::box;
    settings.mode = EditMode::erase;
    moveTo(faceOf({10, 10, kEdge - 1}));
    press();
    moveTo(faceOf({50, 50, kEdge - 1}));
    release();
    ASSERT_TRUE(tools.busy());
    for (std::size_t axis = 0; axis < 3; ++axis) tools.tool()->setFigure(axis, 70);
    frame({}, false, false);
    EXPECT_TRUE(tools.previewsLater());
    EXPECT_FALSE(session.previews());
    tools.finishPreview(session);
    EXPECT_TRUE(session.previews());
    VoxelGrid expected = test::solidBox({kEdge, kEdge, kEdge}, 5);
    expected.fill({{10, 10, 0}, {kEdge, kEdge, kEdge}}, 0);
    EXPECT_EQ(shown(), expected);
    keep();
    EXPECT_EQ(made(), expected);
    expectInOrder();
}

TEST_F(LargeEdits, WhatFloatsStaysInTheAirUntilItIsDown) {
    ASSERT_TRUE(selectEverything(session));
    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& f) { f.moveBy({7, -2, 1}); });
    settings.tool = ToolKind::move;
    frame({}, false, false);
    EXPECT_TRUE(tools.previewsLater());
    tools.finishPreview(session);
    EXPECT_EQ(session.shownOctree().at({70, 0, 10}), 5);
    EXPECT_EQ(session.shownOctree().at({0, 0, 0}), 0);

    Result<std::optional<Action>> landing = putDown(session);
    ASSERT_TRUE(landing && *landing);
    EXPECT_TRUE(session.isLong(**landing));
    EXPECT_TRUE(session.selection().floating());
    // Stopped: it is still there, and nothing has changed.
    std::stop_source stop;
    stop.request_stop();
    ASSERT_FALSE(session.prepare(**landing, Progress({}, stop.get_token())));
    session.dropPrepared();
    EXPECT_TRUE(session.selection().floating());
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 5));

    landing = putDown(session);
    ASSERT_TRUE(landing && *landing);
    ASSERT_TRUE(session.perform(std::move(**landing)));
    EXPECT_FALSE(session.selection().floating());
    EXPECT_EQ(session.bounds(), (IBox{{7, -2, 1}, {7 + kEdge, kEdge - 2, 1 + kEdge}}));
    EXPECT_EQ(session.selection().voxels(), VoxelSet(session.bounds()));
    expectInOrder();
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 5));
    EXPECT_EQ(session.selection().voxels(), VoxelSet(kCube)) << "selected as it was then";
}

TEST_F(LargeEdits, OfTheSelectionAreMadeLater) {
    ASSERT_TRUE(selectEverything(session));
    Result<Action> painted = recolourSelection(session, 3);
    ASSERT_TRUE(painted);
    EXPECT_TRUE(painted->makePatches);
    ASSERT_TRUE(session.perform(std::move(*painted)));
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 3));
    Result<Action> moved = selectionToObject(session);
    ASSERT_TRUE(moved);
    ASSERT_TRUE(session.perform(std::move(*moved)));
    EXPECT_TRUE(session.document().models[0].voxels.empty());
    EXPECT_EQ(session.document().models[1].voxels, test::solidBox({kEdge, kEdge, kEdge}, 3));
    expectInOrder();
    ASSERT_TRUE(session.undo());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(made(), test::solidBox({kEdge, kEdge, kEdge}, 5));
    expectInOrder();
}

TEST_F(LargeEdits, HollowingIsShownAndMade) {
    ASSERT_TRUE(lift(session, settings, Floating::Kind::hollow));
    settings.tool = ToolKind::move;
    frame({}, false, false);
    tools.finishPreview(session);
    VoxelGrid expected = test::solidBox({kEdge, kEdge, kEdge}, 5);
    expected.fill({{1, 1, 1}, {kEdge - 1, kEdge - 1, kEdge - 1}}, 0);
    EXPECT_EQ(session.shownOctree().solidCount(), expected.solidCount());
    keep();
    EXPECT_EQ(made(), expected);
    expectInOrder();
}

TEST_F(LargeEdits, ChangesOfTheSceneAreLongWhereMuchIsSeenAnew) {
    const Document& document = session.document();
    SceneEdit renamed{sceneOf(document), sceneOf(document), document.models.size(), {}};
    renamed.after.nodes[1].name = "Hut";
    EXPECT_FALSE(session.isLong(makeAction("rename", renamed)));
    SceneEdit hidden{sceneOf(document), sceneOf(document), document.models.size(), {}};
    hidden.after.nodes[1].hidden = true;
    EXPECT_FALSE(session.isLong(makeAction("hide", hidden))) << "512 cubes are soon built";
    const VoxelPatch more =
        patchBox(document, 0, {{0, 0, 0}, {160, 160, 160}}, EditMode::attach, 5);
    ASSERT_TRUE(session.perform(makeAction("more", more)));
    EXPECT_TRUE(session.isLong(makeAction("hide", hidden)));
    EXPECT_FALSE(session.isLong(makeAction("rename", renamed)));
}

TEST_F(LargeEdits, StepsOfADragAreMadeOfACopy) {
    const std::size_t before = session.history().steps().size();
    const std::uint64_t key = session.newMergeKey();
    for (const int x : {3, 11}) {
        const Workspace copy = session.workspace();
        auto prepared = Session::prepare(copy, session.frame(),
                                         moveObject(session.document(), 1, {x, -1, 2}, key), {});
        ASSERT_TRUE(prepared);
        EXPECT_EQ(session.workspace().document, copy.document);
        session.commit(std::move(**prepared));
        EXPECT_EQ(session.bounds(), (IBox{{x, -1, 2}, {x + kEdge, kEdge - 1, kEdge + 2}}));
        EXPECT_EQ(session.history().steps().size(), before + 1) << "one drag, one step";
    }
    const Result<Octree> baked = bake(flatten(session.document(), 0), session.bounds());
    ASSERT_TRUE(baked);
    EXPECT_EQ(session.octree().canonical(session.bounds())->nodes, baked->nodes);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.bounds(), kCube);
}

}  // namespace
}  // namespace voxprite::editor
