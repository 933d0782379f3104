#include "core/edit/history.h"

#include <gtest/gtest.h>

#include "core/edit/patches.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::Random;

bool same(const Workspace& a, const Workspace& b) {
    return a.document == b.document && a.profile == b.profile;
}

Action actionOf(ActionPart part, std::uint64_t mergeKey = 0, std::string label = "edit") {
    Action action;
    action.label = std::move(label);
    action.parts.push_back(std::move(part));
    action.mergeKey = mergeKey;
    return action;
}

Action setVoxel(glm::ivec3 v, std::uint8_t value, std::uint64_t mergeKey = 0) {
    return actionOf(VoxelPatch{0, {{v, 0, value}}}, mergeKey);
}

Action setSigma(const Workspace& workspace, double sigma, std::uint64_t mergeKey = 0) {
    ProfileEdit edit{workspace.profile, workspace.profile};
    edit.after.sigma = sigma;
    return actionOf(edit, mergeKey);
}

Action setScale(const Workspace& workspace, double scale, std::uint64_t mergeKey = 0) {
    EntityEdit edit{workspace.document.entity, workspace.document.entity};
    edit.after.scale = scale;
    return actionOf(edit, mergeKey);
}

Action setColour(const Workspace& workspace, std::size_t index, Rgba8 colour) {
    PaletteEdit edit{workspace.document.palette, workspace.document.palette};
    edit.after->colours[index] = colour;
    return actionOf(edit);
}

// Adds a model and an object that shows it.
Action addModel(const Workspace& workspace, VoxelGrid voxels, std::uint64_t mergeKey = 0) {
    const Document& document = workspace.document;
    SceneEdit edit;
    edit.after = sceneOf(document);
    SceneNode object;
    object.parent = 0;
    object.models = {ModelKey{0, static_cast<int>(document.models.size())}};
    edit.after.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
    edit.after.nodes.push_back(std::move(object));
    edit.addedModels.push_back(Model{std::move(voxels), {}});
    return actionOf(std::move(edit), mergeKey);
}

Action randomAction(Random& random, const Workspace& workspace) {
    const std::uint64_t mergeKey =
        random.chance(0.3) ? static_cast<std::uint64_t>(random.between(1, 2)) : 0;
    const int models = static_cast<int>(workspace.document.models.size());
    switch (random.between(0, 9)) {
        case 0:
            return setSigma(workspace, random.between(1, 3), mergeKey);
        case 1:
            return setScale(workspace, random.between(1, 3), mergeKey);
        case 2:
            return setColour(workspace, static_cast<std::size_t>(random.between(1, 255)),
                             Rgba8(random.between(0, 255), 0, 0, 255));
        case 3: {
            if (models < 5)
                return addModel(workspace, test::randomVoxels(random.next(), {3, 3, 3}, 0.5, 9),
                                mergeKey);
            SceneEdit edit;
            edit.after = sceneOf(workspace.document);
            edit.after.nodes.back().hidden = !edit.after.nodes.back().hidden;
            return actionOf(std::move(edit), mergeKey);
        }
        case 4: {
            // Several parts at once, the second onto what the first has drawn.
            Action action = setVoxel(random.voxel(-3, 3), 5, mergeKey);
            action.parts.emplace_back(VoxelPatch{0, {{random.voxel(-3, 3), 0, 6}}});
            action.parts.push_back(setSigma(workspace, random.between(1, 3)).parts[0]);
            return action;
        }
        case 5: {
            const IBox box = IBox::around(random.voxel(-3, 3), random.voxel(-3, 3));
            const auto mode = static_cast<EditMode>(random.between(0, 2));
            return actionOf(
                patchBox(workspace.document, random.between(0, models - 1), box, mode, 7),
                mergeKey);
        }
        default: {
            VoxelPatch patch;
            patch.model = random.between(0, models - 1);
            // Stale befores, and positions that may repeat: neither may matter.
            for (int i = random.between(1, 4); i > 0; --i) {
                patch.changes.push_back(
                    {random.voxel(-3, 3), 99, static_cast<std::uint8_t>(random.between(0, 2))});
            }
            return actionOf(std::move(patch), mergeKey);
        }
    }
}

TEST(History, StartsWithNothingToUndo) {
    History history;
    Workspace workspace;
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
    EXPECT_FALSE(history.undo(workspace).any());
    EXPECT_FALSE(history.redo(workspace).any());
    EXPECT_TRUE(history.isSaved());
    EXPECT_EQ(history.bytes(), 0u);
}

TEST(History, UndoAndRedoOfEachKind) {
    const Workspace start;
    const auto check = [&](const Action& action, const auto& changedAsItShould) {
        History history;
        Workspace workspace = start;
        EXPECT_TRUE(changedAsItShould(history.execute(workspace, action)));
        const Workspace after = workspace;
        EXPECT_FALSE(same(after, start));
        EXPECT_TRUE(changedAsItShould(history.undo(workspace)));
        EXPECT_TRUE(same(workspace, start));
        EXPECT_TRUE(changedAsItShould(history.redo(workspace)));
        EXPECT_TRUE(same(workspace, after));
    };
    check(setVoxel({1, 2, 3}, 4), [](const Changed& c) {
        return c.voxels.size() == 1 && c.voxels[0].model == 0 && !c.palette && !c.entity &&
               !c.profile && !c.scene &&
               c.voxels[0].positions == std::vector<glm::ivec3>{{1, 2, 3}};
    });
    check(setColour(start, 3, Rgba8(1, 2, 3, 4)), [](const Changed& c) {
        return c.palette && c.voxels.empty() && !c.entity && !c.profile && !c.scene;
    });
    check(setScale(start, 2.0), [](const Changed& c) {
        return c.entity && c.voxels.empty() && !c.palette && !c.profile && !c.scene;
    });
    check(setSigma(start, 2.0), [](const Changed& c) {
        return c.profile && c.voxels.empty() && !c.palette && !c.entity && !c.scene;
    });
    check(addModel(start, test::figure()), [](const Changed& c) {
        return c.scene && c.voxels.empty() && !c.palette && !c.entity && !c.profile;
    });
}

TEST(History, WhatChangesNothingIsNotRecorded) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    history.undo(workspace);
    EXPECT_FALSE(history.execute(workspace, setVoxel({0, 0, 0}, 0)).any());
    EXPECT_FALSE(history.execute(workspace, setSigma(workspace, workspace.profile.sigma)).any());
    EXPECT_FALSE(history.execute(workspace, Action{}).any());
    SceneEdit scene;
    scene.after = sceneOf(workspace.document);
    EXPECT_FALSE(history.execute(workspace, actionOf(scene)).any());
    EXPECT_EQ(history.steps().size(), 1u);
    EXPECT_TRUE(history.canRedo()) << "nothing happened, so what was undone can still be redone";
}

TEST(History, ANewStepDropsWhatWasUndone) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    history.execute(workspace, setVoxel({1, 0, 0}, 1));
    history.undo(workspace);
    history.execute(workspace, setVoxel({2, 0, 0}, 1));
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.steps().size(), 2u);
    EXPECT_EQ(test::mapOf(workspace.document.models[0].voxels),
              (test::VoxelMap{{{0, 0, 0}, 1}, {{2, 0, 0}, 1}}));
}

// A walk of thousands of actions, undos and redos. After each step the workspace is compared with
// a copy taken when that state was first reached.
TEST(History, RandomWalksReturnToEveryState) {
    Random random(31);
    History history;
    Workspace workspace;
    std::vector<Workspace> states{workspace};  // states[i] after i steps
    for (int i = 0; i < 3000; ++i) {
        const double dice = random.unit();
        if (dice < 0.5) {
            if (!history.execute(workspace, randomAction(random, workspace)).any()) continue;
            // Merged, new or back at its start: the state belongs to the position reached.
            states.resize(history.position() + 1);
            states[history.position()] = workspace;
        } else if (dice < 0.8) {
            history.undo(workspace);
        } else {
            history.redo(workspace);
        }
        ASSERT_LT(history.position(), states.size());
        ASSERT_TRUE(same(workspace, states[history.position()])) << i;
    }
    while (history.canUndo()) history.undo(workspace);
    EXPECT_TRUE(same(workspace, Workspace{}));
    while (history.canRedo()) history.redo(workspace);
    EXPECT_TRUE(same(workspace, states.back()));
}

TEST(History, LongSequencesUndoToTheStart) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        Random random(seed);
        History history;
        Workspace workspace;
        workspace.document = test::busyDocument();
        const Workspace start = workspace;
        for (int i = 0; i < 5000; ++i) history.execute(workspace, randomAction(random, workspace));
        const Workspace end = workspace;
        EXPECT_GT(history.steps().size(), 1000u);
        while (history.canUndo()) history.undo(workspace);
        EXPECT_TRUE(same(workspace, start));
        while (history.canRedo()) history.redo(workspace);
        EXPECT_TRUE(same(workspace, end));
    }
}

TEST(History, WhatChangedCoversEveryDifference) {
    Random random(32);
    History history;
    Workspace workspace;
    for (int i = 0; i < 600; ++i) {
        Workspace follower = workspace;
        const double dice = random.unit();
        const Changed changed = dice < 0.6
                                    ? history.execute(workspace, randomAction(random, workspace))
                                : dice < 0.8 ? history.undo(workspace)
                                             : history.redo(workspace);
        ASSERT_EQ(changed.any(), !same(follower, workspace));
        // Bring the follower up to date with what is named alone.
        if (changed.scene) {
            follower.document.nodes = workspace.document.nodes;
            follower.document.models.resize(workspace.document.models.size());
            for (std::size_t m = 1; m < follower.document.models.size(); ++m) {
                follower.document.models[m] = workspace.document.models[m];
            }
        }
        for (const Changed::Voxels& voxels : changed.voxels) {
            const auto m = static_cast<std::size_t>(voxels.model);
            if (m >= follower.document.models.size()) continue;  // undone with its model
            for (const glm::ivec3 v : voxels.positions) {
                follower.document.models[m].voxels.set(v,
                                                       workspace.document.models[m].voxels.get(v));
            }
        }
        if (changed.palette) follower.document.palette = workspace.document.palette;
        if (changed.entity) follower.document.entity = workspace.document.entity;
        if (changed.profile) follower.profile = workspace.profile;
        ASSERT_TRUE(same(follower, workspace)) << i;
    }
}

TEST(History, AStrokeBecomesOneStep) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({9, 9, 9}, 1));
    const Workspace before = workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1, 7));
    history.execute(workspace, setVoxel({2, 0, 0}, 2, 7));
    history.execute(workspace, setVoxel({1, 0, 0}, 3, 7));
    history.execute(workspace, setVoxel({0, 0, 0}, 4, 7));
    history.execute(workspace, setVoxel({2, 0, 0}, 0, 7));
    ASSERT_EQ(history.steps().size(), 2u);
    const auto& patch = std::get<VoxelPatch>(history.steps()[1].parts.at(0));
    EXPECT_EQ(patch.changes, (std::vector<VoxelChange>{{{0, 0, 0}, 0, 4}, {{1, 0, 0}, 0, 3}}));
    const Workspace after = workspace;
    history.undo(workspace);
    EXPECT_TRUE(same(workspace, before));
    history.redo(workspace);
    EXPECT_TRUE(same(workspace, after));
    // Another stroke, and then none: steps of their own.
    history.execute(workspace, setVoxel({5, 0, 0}, 1, 8));
    history.execute(workspace, setVoxel({6, 0, 0}, 1));
    history.execute(workspace, setVoxel({7, 0, 0}, 1));
    EXPECT_EQ(history.steps().size(), 5u);
}

TEST(History, ASliderDragBecomesOneStepWithTheLastLabel) {
    History history;
    Workspace workspace;
    for (int i = 1; i <= 50; ++i) {
        Action action = setSigma(workspace, 4.0 + 0.1 * i, 3);
        action.label = "Sigma " + std::to_string(i);
        action.parts.push_back(setScale(workspace, 1.0 + 0.1 * i).parts[0]);
        history.execute(workspace, std::move(action));
    }
    ASSERT_EQ(history.steps().size(), 1u);
    EXPECT_EQ(history.steps()[0].label, "Sigma 50");
    EXPECT_EQ(history.steps()[0].parts.size(), 2u);
    EXPECT_EQ(history.steps()[0].bytes(), history.bytes());
    history.undo(workspace);
    EXPECT_EQ(workspace.profile.sigma, 4.0);
    EXPECT_EQ(workspace.document.entity.scale, 1.0);
}

TEST(History, AStrokeBackToItsStartLeavesNoStep) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({9, 9, 9}, 1));
    history.markSaved();
    history.execute(workspace, setVoxel({0, 0, 0}, 1, 7));
    EXPECT_FALSE(history.isSaved());
    const Changed changed = history.execute(workspace, setVoxel({0, 0, 0}, 0, 7));
    EXPECT_TRUE(changed.any());
    EXPECT_EQ(history.steps().size(), 1u);
    EXPECT_TRUE(history.isSaved());
    EXPECT_EQ(history.bytes(), history.steps()[0].bytes());
    history.execute(workspace, setSigma(workspace, 5.0, 8));
    history.execute(workspace, setSigma(workspace, 4.0, 8));
    EXPECT_EQ(history.steps().size(), 1u);
}

TEST(History, UndoOfASceneEditTakesItsModelsAway) {
    History history;
    Workspace workspace;
    history.execute(workspace, addModel(workspace, test::figure(), 5));
    history.execute(workspace, addModel(workspace, test::asymmetric(), 5));
    history.execute(workspace, actionOf(VoxelPatch{2, {{{50, 50, 50}, 0, 9}}}));
    ASSERT_EQ(history.steps().size(), 2u);
    ASSERT_EQ(workspace.document.models.size(), 3u);
    EXPECT_EQ(workspace.document.models[1].voxels, test::figure());
    const Workspace after = workspace;
    history.undo(workspace);
    EXPECT_EQ(workspace.document.models[2].voxels, test::asymmetric());
    history.undo(workspace);
    EXPECT_EQ(workspace.document.models.size(), 1u);
    EXPECT_EQ(workspace.document.nodes.size(), 2u);
    EXPECT_EQ(std::get<SceneEdit>(history.steps()[0].parts[0]).addedModels.size(), 2u);
    history.redo(workspace);
    history.redo(workspace);
    EXPECT_TRUE(same(workspace, after));
    EXPECT_TRUE(std::get<SceneEdit>(history.steps()[0].parts[0]).addedModels.empty());
}

// What is refused leaves no trace: not in a stroke that it would have joined, nor in what could be
// redone.
TEST(History, WhatNobodyCanFollowIsTakenBack) {
    Workspace workspace;
    History history;
    static_cast<void>(history.execute(workspace, setVoxel({0, 0, 0}, 1, 5)));
    static_cast<void>(history.execute(workspace, setVoxel({1, 0, 0}, 2)));
    static_cast<void>(history.undo(workspace));
    const Workspace before = workspace;
    std::vector<std::size_t> told;
    const auto refuse = [&](const Changed& changed) -> Status {
        told.push_back(changed.voxels.size());
        if (told.size() % 2 == 1) return fail("too long");
        return {};
    };
    EXPECT_FALSE(history.execute(workspace, setVoxel({9, 0, 0}, 3, 5), refuse).any());
    EXPECT_TRUE(same(workspace, before));
    EXPECT_FALSE(history.redo(workspace, refuse).any());
    EXPECT_TRUE(same(workspace, before));
    EXPECT_FALSE(history.undo(workspace, refuse).any());
    EXPECT_TRUE(same(workspace, before));
    EXPECT_EQ(told, std::vector<std::size_t>(6, 1)) << "each step and its way back";
    EXPECT_EQ(history.position(), 1u);
    EXPECT_EQ(history.steps().size(), 2u);
    EXPECT_EQ(history.steps()[0].parts.size(), 1u);
    static_cast<void>(history.undo(workspace));
    EXPECT_TRUE(workspace.document.models[0].voxels.empty());
}

TEST(History, SavedIsWhereItWasSaved) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    EXPECT_FALSE(history.isSaved());
    history.undo(workspace);
    EXPECT_TRUE(history.isSaved());
    history.redo(workspace);
    history.markSaved();
    EXPECT_TRUE(history.isSaved());
    history.undo(workspace);
    EXPECT_FALSE(history.isSaved());
    history.redo(workspace);
    EXPECT_TRUE(history.isSaved());
    // The saved step is on a branch that goes away: no undo or redo leads there again.
    history.undo(workspace);
    history.execute(workspace, setVoxel({5, 0, 0}, 1));
    EXPECT_FALSE(history.isSaved());
    history.undo(workspace);
    EXPECT_FALSE(history.isSaved());
    history.redo(workspace);
    EXPECT_FALSE(history.isSaved());
    history.markSaved();
    history.clear();
    EXPECT_TRUE(history.isSaved());
    history.execute(workspace, setVoxel({6, 0, 0}, 1));
    history.clear();
    EXPECT_FALSE(history.isSaved());
}

TEST(History, WhatDoesNotCountMakesNoDifferenceToWhatWasSaved) {
    const auto counts = [](const ActionPart& part) {
        return !std::holds_alternative<ProfileEdit>(part);
    };
    History history;
    Workspace workspace;
    EXPECT_FALSE(history.differsFromSaved(counts));
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    EXPECT_TRUE(history.differsFromSaved(counts));
    history.markSaved();
    history.execute(workspace, setSigma(workspace, 5.0));
    EXPECT_FALSE(history.isSaved());
    EXPECT_FALSE(history.differsFromSaved(counts));
    history.execute(workspace, setScale(workspace, 2.0));
    EXPECT_TRUE(history.differsFromSaved(counts));
    history.undo(workspace);
    EXPECT_FALSE(history.differsFromSaved(counts));
    history.undo(workspace);
    history.undo(workspace);
    EXPECT_TRUE(history.differsFromSaved(counts)) << "before what was saved";
    history.redo(workspace);
    history.redo(workspace);
    history.markSaved();
    history.undo(workspace);
    EXPECT_FALSE(history.differsFromSaved(counts));
    // No undo or redo leads there again.
    history.execute(workspace, setVoxel({5, 0, 0}, 1));
    history.undo(workspace);
    EXPECT_TRUE(history.differsFromSaved(counts));
}

TEST(History, AStrokeDoesNotMergeIntoASavedStep) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1, 7));
    history.markSaved();
    history.execute(workspace, setVoxel({1, 0, 0}, 1, 7));
    EXPECT_FALSE(history.isSaved());
    history.execute(workspace, setVoxel({2, 0, 0}, 1, 7));
    EXPECT_EQ(history.steps().size(), 2u);
    history.undo(workspace);
    EXPECT_TRUE(history.isSaved());
    EXPECT_EQ(workspace.document.models[0].voxels.solidCount(), 1u);
}

// isSaved() against the truth: is the workspace what it was when it was saved? It may say no where
// other steps led to the same state by chance, but never yes wrongly; and undoing every step back
// to the saved one must say yes.
TEST(History, SavedIsNeverClaimedWrongly) {
    Random random(33);
    History history;
    history.setMemoryLimitBytes(60'000);
    Workspace workspace;
    Workspace saved = workspace;
    int claims = 0;
    for (int i = 0; i < 4000; ++i) {
        const double dice = random.unit();
        if (dice < 0.1) {
            history.markSaved();
            saved = workspace;
        } else if (dice < 0.5) {
            history.execute(workspace, randomAction(random, workspace));
        } else if (dice < 0.75) {
            history.undo(workspace);
        } else {
            history.redo(workspace);
        }
        if (!history.isSaved()) continue;
        ++claims;
        ASSERT_TRUE(same(workspace, saved)) << i;
    }
    EXPECT_GT(claims, 500);
}

TEST(History, TheMemoryLimitDropsTheOldestSteps) {
    History history;
    Workspace workspace;
    history.setMemoryLimitBytes(20'000);
    for (int i = 0; i < 200; ++i) {
        history.execute(workspace, setVoxel({i, 0, 0}, 1));
        std::size_t sum = 0;
        for (const Action& step : history.steps()) sum += step.bytes();
        ASSERT_EQ(history.bytes(), sum);
        ASSERT_LE(history.bytes(), 20'000u);
        ASSERT_EQ(history.position(), history.steps().size());
    }
    const std::size_t kept = history.steps().size();
    EXPECT_GT(kept, 10u);
    EXPECT_LT(kept, 200u);
    EXPECT_FALSE(history.isSaved());
    while (history.canUndo()) history.undo(workspace);
    EXPECT_FALSE(history.isSaved()) << "the start cannot be reached any more";
    EXPECT_EQ(workspace.document.models[0].voxels.solidCount(), 200u - kept);
}

TEST(History, TheNewestStepStaysHoweverLargeItIs) {
    History history;
    Workspace workspace;
    history.setMemoryLimitBytes(1000);
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    history.execute(workspace, actionOf(patchBox(workspace.document, 0, {{0, 0, 0}, {20, 20, 20}},
                                                 EditMode::attach, 3)));
    EXPECT_EQ(history.steps().size(), 1u);
    EXPECT_GT(history.bytes(), 1000u);
    history.undo(workspace);
    EXPECT_EQ(workspace.document.models[0].voxels.solidCount(), 1u);
}

TEST(History, AStepForOneVoxelIsSmall) {
    History history;
    Workspace workspace;
    history.execute(workspace, setVoxel({0, 0, 0}, 1));
    EXPECT_LT(history.bytes(), 1024u);
}

}  // namespace
}  // namespace voxprite
