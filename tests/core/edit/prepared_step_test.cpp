// Steps in two halves do what they do in one.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/edit/scene_edits.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::Random;

bool same(const Workspace& a, const Workspace& b) {
    return a.document == b.document && a.profile == b.profile;
}

// Some voxels, a colour, now and then an object: of every kind that undoing treats on its own.
Action randomAction(Random& random, const Workspace& workspace) {
    VoxelPatch patch{0, {}};
    for (int i = random.between(1, 60); i > 0; --i) {
        patch.changes.push_back(
            {random.voxel(-6, 6), 0, static_cast<std::uint8_t>(random.between(0, 3))});
    }
    Action action = makeAction("voxels", std::move(patch));
    if (random.chance(0.3)) {
        PaletteEdit edit{workspace.document.palette, workspace.document.palette};
        edit.after->colours[5] = Rgba8(random.between(0, 255), 1, 2, 255);
        action.parts.emplace_back(std::move(edit));
    }
    if (random.chance(0.3)) {
        Action added = addObject(workspace.document, "Part");
        std::get<SceneEdit>(added.parts.front()).addedModels.front().voxels =
            test::solidBox({2, 3, 1});
        action.parts.insert(action.parts.begin(), std::move(added.parts.front()));
    }
    return action;
}

TEST(PreparedStep, DoesWhatTheStepDoes) {
    Random random(31);
    Workspace atOnce, prepared;
    History first, second;
    for (int round = 0; round < 300; ++round) {
        const int kind = random.between(0, 3);
        if (kind <= 1) {
            const Action action = randomAction(random, atOnce);
            (void)first.execute(atOnce, action);
            Result<PreparedStep> step = History::prepare(prepared, action);
            ASSERT_TRUE(step);
            (void)second.commit(prepared, std::move(*step));
        } else if (kind == 2 && first.canUndo()) {
            (void)first.undo(atOnce);
            Result<PreparedStep> step = second.prepareUndo(prepared);
            ASSERT_TRUE(step);
            (void)second.commit(prepared, std::move(*step));
        } else if (kind == 3 && first.canRedo()) {
            (void)first.redo(atOnce);
            Result<PreparedStep> step = second.prepareRedo(prepared);
            ASSERT_TRUE(step);
            (void)second.commit(prepared, std::move(*step));
        }
        ASSERT_TRUE(same(atOnce, prepared)) << "round " << round;
        ASSERT_EQ(first.position(), second.position());
        ASSERT_EQ(first.steps().size(), second.steps().size());
    }
    // And each leads back the other's way.
    while (second.canUndo()) (void)second.undo(prepared);
    EXPECT_TRUE(same(prepared, Workspace{}));
}

TEST(PreparedStep, TouchesNothingUntilItIsCommitted) {
    Workspace workspace;
    History history;
    const VoxelPatch patch =
        patchBox(workspace.document, 0, {{0, 0, 0}, {3, 3, 3}}, EditMode::attach, 4);
    (void)history.execute(workspace, makeAction("box", patch));
    const Workspace before = workspace;
    Result<PreparedStep> undo = history.prepareUndo(workspace);
    ASSERT_TRUE(undo);
    EXPECT_TRUE(same(workspace, before));
    EXPECT_EQ(history.position(), 1u);
    const Changed changed = history.commit(workspace, std::move(*undo));
    EXPECT_TRUE(same(workspace, Workspace{}));
    EXPECT_EQ(history.position(), 0u);
    ASSERT_EQ(changed.voxels.size(), 1u);
    EXPECT_EQ(changed.voxels.front().model, 0);
}

TEST(PreparedStep, ThatChangesNothingIsNoStep) {
    Workspace workspace;
    History history;
    Result<PreparedStep> step =
        History::prepare(workspace, makeAction("air", VoxelPatch{0, {{{1, 2, 3}, 0, 0}}}));
    ASSERT_TRUE(step);
    EXPECT_FALSE(history.commit(workspace, std::move(*step)).any());
    EXPECT_TRUE(history.steps().empty());
}

TEST(PreparedStep, FindsItsVoxelsWhenItIsCarriedOut) {
    Workspace workspace;
    History history;
    Action later = makeActionLater("later", [](const Document& document) {
        return onePatch(
            patchSet(document, 0, VoxelSet(IBox{{0, 0, 0}, {4, 4, 4}}), EditMode::attach, 2));
    });
    ASSERT_TRUE(makeParts(later, workspace.document));
    ASSERT_EQ(later.parts.size(), 1u);
    EXPECT_FALSE(later.makePatches);
    (void)history.execute(workspace, std::move(later));
    EXPECT_EQ(workspace.document.models[0].voxels.solidCount(), 64u);

    const Result<PreparedStep> failing =
        History::prepare(workspace, makeActionLater("never", [](const Document&) {
                             return onePatch(Result<VoxelPatch>(fail("no such voxels")));
                         }));
    ASSERT_FALSE(failing);
    EXPECT_EQ(failing.error().message, "no such voxels");
}

TEST(PreparedStep, TellsHowFarItIsAndStops) {
    Workspace workspace;
    const VoxelPatch patch =
        patchBox(workspace.document, 0, {{0, 0, 0}, {64, 64, 64}}, EditMode::attach, 4);
    std::vector<double> shares;
    const Progress told([&](double share) { shares.push_back(share); }, {});
    ASSERT_TRUE(History::prepare(workspace, makeAction("box", patch), told.part(0.5, 1.0)));
    ASSERT_GE(shares.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GE(shares.front(), 0.5);
    EXPECT_GT(shares.back(), 0.8);
    EXPECT_LE(shares.back(), 1.0);

    // Stopped a quarter of the way.
    std::stop_source stop;
    const Progress stopping(
        [&](double share) {
            if (share > 0.25) stop.request_stop();
        },
        stop.get_token());
    EXPECT_FALSE(History::prepare(workspace, makeAction("box", patch), stopping));
    EXPECT_TRUE(same(workspace, Workspace{}));
}

}  // namespace
}  // namespace voxprite
