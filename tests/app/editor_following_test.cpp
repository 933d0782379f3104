// What follows the document through every step: which object is in hand, what is selected, and
// whether the picture can go along at all.
#include <gtest/gtest.h>

#include <array>

#include "app/editor/session/selection_edits.h"
#include "app/editor/session/session.h"
#include "core/edit/frame_edits.h"
#include "core/edit/make_action.h"
#include "core/edit/scene_edits.h"
#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/app/tool_hand.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

constexpr int kFar = 32'000;

// Three boxes of 64 voxels in a row, the nodes 1 to 3.
Document threeBoxes() {
    Document document = test::documentOf(test::solidBox({4, 4, 4}, 7));
    document.nodes[1].name = "a";
    for (int i = 1; i < 3; ++i) {
        document.models.push_back(
            {test::solidBox({4, 4, 4}, static_cast<std::uint8_t>(7 + i)), {}});
        SceneNode node = document.nodes[1];
        node.name = i == 1 ? "b" : "c";
        node.models = {ModelKey{0, i}};
        node.placements.front().placement.translation = {10 * i, 0, 0};
        document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
        document.nodes.push_back(node);
    }
    return document;
}

class Following : public testing::Test {
  protected:
    Following() { open(threeBoxes()); }
    void open(const Document& document) {
        const test::TemporaryFolder folder;
        EXPECT_TRUE(saveDocument(folder / "a.voxprite", document, GameProfile{}));
        EXPECT_TRUE(session.open(folder / "a.voxprite"));
    }
    void perform(Action action) { ASSERT_TRUE(session.perform(std::move(action))); }
    [[nodiscard]] std::string nameOf(int node) const {
        return node < 0 ? "" : session.document().nodes[static_cast<std::size_t>(node)].name;
    }
    [[nodiscard]] std::string active() const { return nameOf(session.activeNode()); }
    [[nodiscard]] std::uint64_t solid(std::size_t model) const {
        return session.document().models[model].voxels.solidCount();
    }
    void expectConsistent() const {
        EXPECT_EQ(session.bounds(), entityBounds(session.document()));
        const Octree baked =
            test::must(bake(flatten(session.document(), session.frame()), session.bounds()));
        EXPECT_EQ(test::must(session.octree().canonical(session.bounds())), baked);
    }

    Session session;
    const VoxelSet corner{IBox{{0, 0, 0}, {2, 1, 1}}};
};

TEST_F(Following, TheObjectInHandStaysTheSameWhenOthersGo) {
    session.setActiveNode(2);
    perform(deleteNodes(session.document(), std::array{1}));
    EXPECT_EQ(active(), "b");
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(active(), "b");
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(active(), "b");

    perform(groupNodes(session.document(), std::array{1}, "group"));
    perform(moveNodes(session.document(), std::array{2}, 3, 0).value());
    session.setActiveNode(2);
    EXPECT_EQ(active(), "c");
    perform(ungroup(session.document(), 3));
    EXPECT_EQ(active(), "c");
}

TEST_F(Following, WhatIsSelectedStaysInItsObjectWhenOthersGo) {
    session.setActiveNode(2);
    session.selection().select(2, 1, corner);
    perform(deleteNodes(session.document(), std::array{1}));
    EXPECT_EQ(nameOf(session.selection().node()), "b");
    perform(deleteSelection(session, "Delete").value());
    EXPECT_EQ(solid(1), 62u);
    EXPECT_EQ(solid(2), 64u);
    ASSERT_TRUE(session.undo());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(nameOf(session.selection().node()), "b");
    EXPECT_EQ(session.selection().voxels(), corner);
    perform(deleteNodes(session.document(), std::array{2}));
    EXPECT_TRUE(session.selection().empty());
}

TEST_F(Following, WhatFloatsGoesWithItsObject) {
    session.setActiveNode(3);
    ASSERT_TRUE(lift(session, {}, Floating::Kind::move));
    perform(deleteNodes(session.document(), std::array{1}));
    ASSERT_TRUE(session.selection().floating());
    EXPECT_EQ(nameOf(session.selection().floating()->node), "c");
    perform(deleteNodes(session.document(), std::array{2}));
    EXPECT_FALSE(session.selection().floating());
}

// Of the steps here the octree could not hold the last.
TEST_F(Following, WhatIsTooLongForAnOctreeIsTakenBackForGood) {
    perform(moveObject(session.document(), 1, {-kFar, 0, 0}, 0));
    const std::uint64_t drag = session.newMergeKey();
    perform(moveObject(session.document(), 3, {100, 0, 0}, drag));
    perform(moveObject(session.document(), 3, {200, 0, 0}, drag));
    const Document before = session.document();
    const std::size_t steps = session.history().steps().size();
    const Status refused =
        session.perform(moveObject(session.document(), 3, {2 * kFar, 0, 0}, drag));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("octree"), std::string::npos);
    EXPECT_EQ(session.document(), before) << "the drag is where it was before";
    EXPECT_EQ(session.history().steps().size(), steps);
    EXPECT_FALSE(session.history().canRedo());
    expectConsistent();
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(session.document(), before);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.bounds().max.x, 24);
    expectConsistent();

    // What was undone before can still be done again.
    EXPECT_FALSE(session.perform(moveObject(session.document(), 3, {2 * kFar, 0, 0}, 0)));
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(session.document(), before);
}

TEST_F(Following, VoxelsOfAStepThatChangesTheSceneTooAreNew) {
    session.selection().select(2, 1, corner);
    const std::uint64_t before = session.voxelRevision(1);
    perform(selectionToObject(session).value());
    EXPECT_EQ(solid(1), 62u);
    EXPECT_NE(session.voxelRevision(1), before);
}

TEST_F(Following, APartStaysInPlaceUnderARootThatLiesElsewhere) {
    Document document = threeBoxes();
    document.nodes[0].placements.front().placement.translation = {100, 20, 3};
    open(document);
    const IBox bounds = session.bounds();
    session.selection().select(2, 1, corner);
    perform(selectionToObject(session).value());
    EXPECT_EQ(session.bounds(), bounds);
}

// A selection is of one model; another frame may show another.
TEST_F(Following, WhatIsSelectedInAnotherFrameIsNotTheWholeObject) {
    open(test::animationOf({test::solidBox({8, 8, 8}), test::solidBox({8, 8, 8})}));
    session.selection().select(1, 0, corner);
    EXPECT_TRUE(selectionShows(session));
    ASSERT_TRUE(session.setFrame(1));
    EXPECT_FALSE(selectionShows(session));
    EXPECT_EQ(deleteSelection(session, "Delete").error().message,
              "What is selected does not show in this frame");
    EXPECT_FALSE(cropToSelection(session));
    EXPECT_FALSE(recolourSelection(session, 3));
    EXPECT_FALSE(lift(session, {}, Floating::Kind::move));
    EXPECT_FALSE(invertSelection(session));
    EXPECT_EQ(session.selection().voxels(), corner);
    session.selection().clear();
    EXPECT_TRUE(deleteSelection(session, "Delete")) << "the whole object, when that is meant";
}

TEST_F(Following, AFullPaletteElsewhereLeavesTheClipboardAsItWas) {
    Document mine = Document::withEmptyModel();
    mine.palette.colours[5] = Rgba8(1, 2, 3, 255);
    mine.models[0].voxels.set({0, 0, 0}, 5);
    Document full = Document::withEmptyModel();
    for (int i = 1; i < 256; ++i) {
        full.palette.colours[static_cast<std::size_t>(i)] = Rgba8(200, i, 0, 255);
        full.models[0].voxels.set({i, 0, 0}, static_cast<std::uint8_t>(i));
    }
    open(mine);
    ASSERT_TRUE(copySelection(session));
    open(full);
    std::string said;
    ASSERT_TRUE(fitClip(session, said));
    EXPECT_NE(said, "");
    EXPECT_TRUE(clipFits(session));
    EXPECT_NE(session.clip()->voxels.get({0, 0, 0}), 5);
    open(mine);
    said.clear();
    EXPECT_FALSE(clipFits(session));
    ASSERT_TRUE(fitClip(session, said));
    EXPECT_EQ(said, "");
    EXPECT_EQ(session.clip()->voxels.get({0, 0, 0}), 5);
}

using InFrames = test::ToolHand;

TEST_F(InFrames, WhatFloatsComesDownInTheFrameThatItWasLiftedIn) {
    attachBox({{0, 0, 0}, {4, 4, 4}}, 7);
    ASSERT_TRUE(session.perform(test::must(addFrame(session.document(), 1, 0, NewFrame::copy))));
    settings.choose(ToolKind::move);
    moveTo({1, 1});
    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& floating) { floating.moveBy({0, 0, 10}); });
    moveTo({2, 2});
    ASSERT_TRUE(session.setFrame(1));
    moveTo({3, 3});
    EXPECT_FALSE(session.selection().floating());
    EXPECT_EQ(session.document().models[0].voxels.bounds().min.z, 10);
    EXPECT_EQ(session.document().models[1].voxels.bounds().min.z, 0);
}

}  // namespace
}  // namespace voxprite::editor
