#include "core/edit/scene_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/edit/frame_edits.h"
#include "core/edit/socket_edits.h"
#include "core/edit/transforms.h"
#include "core/model/entity_voxels.h"
#include "tests/support/edits.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::after;
using test::Random;
using testing::ElementsAre;

int nodeNamed(const Document& document, const std::string& name) {
    const auto found = std::ranges::find(document.nodes, name, &SceneNode::name);
    EXPECT_NE(found, document.nodes.end()) << name;
    return static_cast<int>(found - document.nodes.begin());
}

const SceneNode& node(const Document& document, const std::string& name) {
    return document.nodes[static_cast<std::size_t>(nodeNamed(document, name))];
}

int modelOf(const Document& document, const std::string& name) {
    return node(document, name).models.front().model;
}

std::vector<std::string> childrenOf(const Document& document, const std::string& name) {
    std::vector<std::string> names;
    for (const int child : node(document, name).children) {
        names.push_back(document.nodes[static_cast<std::size_t>(child)].name);
    }
    return names;
}

// Every object of every frame by its name: which voxels lie where, in whatever order.
using Placed = std::tuple<int, std::string, test::VoxelMap>;
std::vector<Placed> placedVoxels(const Document& document) {
    std::vector<Placed> placed;
    for (int frame = 0; frame < frameCount(document); ++frame) {
        for (const Instance& instance : instancesOf(document, frame, true)) {
            test::VoxelMap voxels;
            document.models[static_cast<std::size_t>(instance.model)].voxels.forEachSolid(
                [&](glm::ivec3 v, std::uint8_t value) {
                    const glm::ivec3 at = instance.entityFromModel.applyToVoxel(v);
                    voxels[{at.x, at.y, at.z}] = value;
                });
            placed.emplace_back(frame, document.nodes[static_cast<std::size_t>(instance.node)].name,
                                voxels);
        }
    }
    std::ranges::sort(placed);
    return placed;
}

std::vector<test::VoxelMap> framesOf(const Document& document) {
    std::vector<test::VoxelMap> frames;
    for (int frame = 0; frame < frameCount(document); ++frame) {
        frames.push_back(test::mapOf(flatten(document, frame)));
    }
    return frames;
}

// Three boxes in a row, one under the other in the list.
Document threeBoxes() {
    Document document = test::documentOf(test::solidBox({2, 3, 4}, 1));
    document.nodes[1].name = "a";
    for (const char* name : {"b", "c"}) {
        Workspace workspace{document, {}};
        History history;
        static_cast<void>(history.execute(workspace, addObject(document, name)));
        document = workspace.document;
        document.models.back().voxels = test::solidBox({3, 2, 1}, 2);
    }
    return document;
}

TEST(SceneEdits, ALinkedCopySharesItsModelAndStandsAfterTheOriginal) {
    const Document before = threeBoxes();
    const Document linked = after(before, duplicateNode(before, 1, Copy::linked));
    EXPECT_EQ(linked.models.size(), before.models.size());
    EXPECT_EQ(linked.nodes.back().models, before.nodes[1].models);
    EXPECT_THAT(linked.nodes[0].children, ElementsAre(1, 4, 2, 3));
    EXPECT_EQ(linked.nodes.back().name, "a 2");
    EXPECT_TRUE(sharesModels(linked, 1));
    EXPECT_TRUE(sharesModels(linked, 4));

    const Document own = after(before, duplicateNode(before, 1, Copy::own));
    EXPECT_EQ(own.nodes.back().models[0].model, 3);
    EXPECT_EQ(own.models.back(), before.models[0]);
    EXPECT_FALSE(sharesModels(own, 1));
    const Document again = after(own, duplicateNode(own, 4, Copy::own));
    EXPECT_EQ(again.nodes.back().name, "a 3");
}

TEST(SceneEdits, ASingleUserHasModelsOfItsOwnAndTheOthersKeepSharing) {
    const Document before = test::busyDocument();
    const int letter = nodeNamed(before, "letter");
    ASSERT_TRUE(sharesModels(before, letter));
    const Document single = after(before, makeSingleUser(before, letter));
    EXPECT_FALSE(sharesModels(single, letter));
    EXPECT_EQ(single.models.size(), before.models.size() + 1);
    EXPECT_EQ(single.models.back(), before.models[0]);
    EXPECT_EQ(modelOf(single, "mirrored letter"), modelOf(single, "tumbled letter"));
    EXPECT_EQ(framesOf(single), framesOf(before));
    // A group: what it shares within itself stays shared.
    const Document group = after(before, makeSingleUser(before, nodeNamed(before, "left")));
    EXPECT_EQ(modelOf(group, "mirrored letter"), modelOf(group, "tumbled letter"));
    EXPECT_NE(modelOf(group, "mirrored letter"), modelOf(group, "letter"));
}

TEST(SceneEdits, ACopiedGroupSharesWithinItselfAsTheOriginalDoes) {
    const Document before = test::busyDocument();
    const int left = nodeNamed(before, "left");
    const Document copied = after(before, duplicateNode(before, left, Copy::own));
    const auto first = before.nodes.size();
    EXPECT_EQ(copied.nodes[first].name, "left 2");
    EXPECT_EQ(copied.nodes.size(), first + 5);  // two groups, three objects
    EXPECT_EQ(copied.models.size(), before.models.size() + 2);
    EXPECT_FALSE(sharesModels(copied, static_cast<int>(first)));
    const std::vector<test::VoxelMap> frames = framesOf(before);
    EXPECT_EQ(framesOf(copied)[0].size(), frames[0].size());  // it lies where the original lies
}

TEST(SceneEdits, FourQuarterTurnsAreNoneAndATurnBackLeadsBack) {
    const Document before = test::busyDocument();
    for (const char* name : {"letter", "noise", "left", "nothing", "empty group"}) {
        const int index = nodeNamed(before, name);
        for (int axis = 0; axis < 3; ++axis) {
            const Document once = after(before, turnNode(before, index, 0, axis, 1));
            EXPECT_EQ(after(once, turnNode(once, index, 0, axis, -1)), before) << name << axis;
            Document turned = once;
            for (int turn = 0; turn < 3; ++turn) {
                turned = after(turned, turnNode(turned, index, 0, axis, 1));
            }
            EXPECT_EQ(turned, before) << name << axis;
            EXPECT_EQ(after(once, turnNode(once, index, 0, axis, 1)),
                      after(before, turnNode(before, index, 0, axis, 2)))
                << name << axis;
            const Document mirrored = after(before, mirrorNode(before, index, 0, axis));
            EXPECT_EQ(nodeBounds(mirrored, index, 0), nodeBounds(before, index, 0));
            EXPECT_EQ(after(mirrored, mirrorNode(mirrored, index, 0, axis)), before);
        }
    }
}

TEST(SceneEdits, AQuarterTurnIsCounterClockwiseAroundTheMiddle) {
    Document document = test::documentOf(VoxelGrid{});
    document.models[0].voxels.set({0, 0, 0}, 1);  // a row along x, from 1 to 3
    document.models[0].voxels.set({1, 0, 0}, 2);
    document.models[0].voxels.set({2, 0, 0}, 3);
    const Document turned = after(document, turnNode(document, 1, 0, 2, 1));
    EXPECT_EQ(test::mapOf(flatten(turned, 0)),
              (test::VoxelMap{{{1, -1, 0}, 1}, {{1, 0, 0}, 2}, {{1, 1, 0}, 3}}));
}

TEST(SceneEdits, MovingInTheTreeLeavesEverythingWhereItIs) {
    const Document before = test::busyDocument();
    const std::vector<Placed> placed = placedVoxels(before);
    for (const auto& [names, group] :
         std::initializer_list<std::pair<std::vector<std::string>, std::string>>{
             {{"letter"}, "left"},           // into a group that moves
             {{"mirrored letter"}, "root"},  // out of it
             {{"tumbled letter", "walker"}, "empty group"},
             {{"inner", "hidden"}, "root"},
             {{"overlap"}, "inner"}}) {
        std::vector<int> nodes;
        for (const std::string& name : names) nodes.push_back(nodeNamed(before, name));
        Result<Action> action = moveNodes(before, nodes, nodeNamed(before, group), 0);
        ASSERT_TRUE(action) << action.error().message;
        const Document moved = after(before, std::move(*action));
        EXPECT_EQ(placedVoxels(moved), placed) << names[0];
        EXPECT_EQ(childrenOf(moved, group)[0], names[0]);
        EXPECT_EQ(frameCount(moved), frameCount(before));
    }
}

TEST(SceneEdits, PositionsCountTheChildrenAsTheyAre) {
    const Document before = threeBoxes();
    const auto order = [&](std::vector<int> nodes, int position) {
        Result<Action> action = moveNodes(before, nodes, 0, position);
        return after(before, std::move(*action)).nodes[0].children;
    };
    EXPECT_THAT(order({1}, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(order({1}, 1), ElementsAre(1, 2, 3));
    EXPECT_THAT(order({1}, 2), ElementsAre(2, 1, 3));
    EXPECT_THAT(order({1}, 3), ElementsAre(2, 3, 1));
    EXPECT_THAT(order({3, 1}, 1), ElementsAre(1, 3, 2));
}

TEST(SceneEdits, AGroupCannotGoIntoItselfNorAnythingIntoAnObject) {
    const Document document = test::busyDocument();
    const int left = nodeNamed(document, "left");
    const Result<Action> inside =
        moveNodes(document, std::array{left}, nodeNamed(document, "inner"), 0);
    ASSERT_FALSE(inside);
    EXPECT_EQ(inside.error().message, "a group cannot be put into itself");
    EXPECT_FALSE(moveNodes(document, std::array{left}, left, 0));
    EXPECT_FALSE(moveNodes(document, std::array{left}, nodeNamed(document, "letter"), 0));
}

TEST(SceneEdits, GroupingAndUngroupingLeaveEverythingWhereItIs) {
    const Document before = test::busyDocument();
    const std::vector<Placed> placed = placedVoxels(before);
    const std::array nodes{nodeNamed(before, "walker"), nodeNamed(before, "tumbled letter"),
                           nodeNamed(before, "inner"), 0};
    const Document grouped = after(before, groupNodes(before, nodes, "team"));
    EXPECT_EQ(grouped.nodes.back().name, "team");
    EXPECT_THAT(childrenOf(grouped, "team"), ElementsAre("inner", "walker"));
    EXPECT_EQ(placedVoxels(grouped), placed);
    const Document apart = after(grouped, ungroup(grouped, nodeNamed(grouped, "team")));
    EXPECT_EQ(placedVoxels(apart), placed);
    // A group that moves, with its own key as the animation's last.
    const Document flat = after(before, ungroup(before, nodeNamed(before, "left")));
    EXPECT_EQ(placedVoxels(flat), placed);
    EXPECT_EQ(frameCount(flat), 5);
    EXPECT_THAT(childrenOf(flat, "root"),
                testing::IsSupersetOf({"inner", "mirrored letter", "walker"}));
}

// Places between keys are rounded down, which a turned group sees the other way round.
TEST(SceneEdits, WhatGlidesStaysInPlaceOutOfATurnedGroup) {
    const Document flat = threeBoxes();
    const std::array alone{nodeNamed(flat, "a")};
    Document grouped = after(flat, groupNodes(flat, alone, "team"));
    const auto nodeOf = [&](const std::string& name) -> SceneNode& {
        return grouped.nodes[static_cast<std::size_t>(nodeNamed(grouped, name))];
    };
    nodeOf("team").placements[0].placement.rotation.sign = {-1, -1, 1};
    nodeOf("a").placements = {{0, {}}, {3, {{}, {1, 0, 0}}}};
    nodeOf("a").glides = true;
    const Document apart = after(grouped, ungroup(grouped, nodeNamed(grouped, "team")));
    EXPECT_EQ(placedVoxels(apart), placedVoxels(grouped));
}

TEST(SceneEdits, WhatLaysInAHiddenGroupStaysHidden) {
    Document before = test::busyDocument();
    before.nodes[1].hidden = true;
    before.nodes[1].locked = true;
    const Document flat = after(before, ungroup(before, 1));
    EXPECT_EQ(framesOf(flat), framesOf(before));
    EXPECT_TRUE(node(flat, "mirrored letter").hidden);
    EXPECT_TRUE(node(flat, "mirrored letter").locked);
}

TEST(SceneEdits, WhatLaysInAGroupOfAHiddenLayerStaysHidden) {
    Document before = test::busyDocument();
    before.nodes[1].layer = 1;
    const auto other = static_cast<std::size_t>(nodeNamed(before, "mirrored letter"));
    before.nodes[other].layer = 0;
    const Document flat = after(before, ungroup(before, 1));
    EXPECT_EQ(framesOf(flat), framesOf(before));
    EXPECT_TRUE(node(flat, "mirrored letter").hidden);
    EXPECT_FALSE(node(flat, "inner").hidden) << "it shows when the layer does";
}

TEST(SceneEdits, MergedObjectsShowWhatTheyShowedInEveryFrame) {
    Document before = test::busyDocument();
    for (SceneNode& each : before.nodes) each.hidden = false;
    before.layers[1].hidden = false;
    std::vector<int> all(before.nodes.size());
    std::iota(all.begin(), all.end(), 0);
    const Document merged = after(before, mergeNodes(before, all, "one"));
    EXPECT_EQ(framesOf(merged), framesOf(before));
    EXPECT_EQ(merged.nodes.size(), 2u);
    // Frames that show the same share a model: the first two do.
    EXPECT_EQ(merged.models.size(), before.models.size() + 4);

    // Under a group that moves.
    const std::array pair{nodeNamed(before, "mirrored letter"), nodeNamed(before, "inner")};
    const Document within = after(before, mergeNodes(before, pair, "one"));
    EXPECT_EQ(framesOf(within), framesOf(before));
    EXPECT_EQ(within.nodes.back().parent, nodeNamed(within, "left"));

    // Under a root that lies elsewhere, and one that moves.
    before.nodes[0].placements.front().placement = {quarterTurns(2, 1), {100, -7, 3}};
    const Document shifted = after(before, mergeNodes(before, all, "one"));
    EXPECT_EQ(framesOf(shifted), framesOf(before));
    before.nodes[0].placements.push_back({2, {{}, {1, 2, 3}}});
    const Document moving = after(before, mergeNodes(before, all, "one"));
    EXPECT_EQ(framesOf(moving), framesOf(before));
}

TEST(SceneEdits, DeletingTheOnlyAnimatedObjectCutsTheClips) {
    Document before = test::animationOf(
        {test::solidBox({1, 1, 1}), test::solidBox({2, 2, 2}), test::solidBox({3, 3, 3})});
    before = after(before, addObject(before, "still"));
    before.clips = {Clip{"a", 0, 1, 8.0, true, {10, 20}}, Clip{"b", 1, 2, 8.0, true, {}}};
    const Document left = after(before, deleteNodes(before, std::array{1}));
    EXPECT_EQ(frameCount(left), 1);
    EXPECT_EQ(left.clips, (std::vector{Clip{"a", 0, 0, 8.0, true, {10}}}));
}

// One of all the edits there are, on something at random; nothing when it makes no sense there.
std::optional<Action> randomEdit(const Document& document, Random& random) {
    const auto last = static_cast<int>(document.nodes.size()) - 1;
    const int any = random.between(last > 0 ? 1 : 0, last);
    const int other = random.between(0, last);
    const int frames = frameCount(document);
    const int frame = random.between(0, frames - 1);
    const bool group = document.nodes[static_cast<std::size_t>(any)].isGroup();
    const std::array nodes{any, std::max(other, 1)};
    const auto key = static_cast<std::uint64_t>(random.between(0, 2));
    const auto position = [&] { return glm::dvec3(random.voxel(-100, 100)) + random.unit(); };
    const auto taken = [](Result<Action> action) {
        return action ? std::optional(std::move(*action)) : std::nullopt;
    };
    const int what = random.between(0, 22);
    if (last == 0 && what != 4 && what != 5) return std::nullopt;
    switch (what) {
        case 0:
            return setHidden(document, any, random.chance(0.5));
        case 1:
            return setLocked(document, any, random.chance(0.5));
        case 2:
            return rename(document, any, "n" + std::to_string(random.between(0, 99)));
        case 3:
            return moveObject(document, any, random.voxel(-50, 50), key);
        case 4:
        case 5:
            return addObject(document, "new");
        case 6:
            return duplicateNode(document, any, Copy::own);
        case 7:
            return duplicateNode(document, any, Copy::linked);
        case 8:
            return makeSingleUser(document, any);
        case 9:
            return deleteNodes(document, std::array{any});
        case 10:
            return turnNode(document, any, frame, random.between(0, 2), random.between(1, 3));
        case 11:
            return mirrorNode(document, any, frame, random.between(0, 2));
        case 12:
        case 13:
            return taken(moveNodes(document, nodes, other, random.between(0, 3)));
        case 14:
            return groupNodes(document, nodes, "group");
        case 15:
            return group ? std::optional(ungroup(document, any)) : std::nullopt;
        case 16:
            return mergeNodes(document, nodes, "merged");
        case 17:
            if (group || frames > 12) return std::nullopt;
            return taken(
                addFrame(document, any, frame, static_cast<NewFrame>(random.between(0, 2))));
        case 18:
            return taken(deleteFrame(document, frame));
        case 19:
            return moveFrame(document, frame, random.between(0, frames - 1));
        case 20:
            return addSocket(document, position());
        case 21:
            if (document.sockets.empty()) return std::nullopt;
            return moveSocket(document, 0, frame, position(),
                              static_cast<SocketReach>(random.between(0, 1)), key);
        default:
            return addClip(document, random.between(0, frame), frame);
    }
}

TEST(SceneEdits, AnySequenceIsUndoneAndRedoneExactlyAndStaysValid) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Random random(seed);
        Workspace workspace{test::busyDocument(), {}};
        History history;
        std::vector<Document> states{workspace.document};
        for (int step = 0; step < 60; ++step) {
            if (workspace.document.nodes.size() > 60) break;
            std::optional<Action> action = randomEdit(workspace.document, random);
            if (!action) continue;
            const std::string label = action->label;
            const std::size_t before = history.position();
            static_cast<void>(history.execute(workspace, std::move(*action)));
            const Status valid = validate(workspace.document);
            ASSERT_TRUE(valid) << seed << ", step " << step << ", " << label << ": "
                               << valid.error().message;
            if (history.position() == before + 1) {
                states.push_back(workspace.document);
            } else {
                states.resize(history.position() + 1);  // merged, possibly into nothing
                states.back() = workspace.document;
            }
        }
        const Document end = workspace.document;
        for (std::size_t step = states.size() - 1; step > 0; --step) {
            static_cast<void>(history.undo(workspace));
            ASSERT_EQ(workspace.document, states[step - 1]) << seed << ", undo to " << step - 1;
        }
        while (history.canRedo()) static_cast<void>(history.redo(workspace));
        ASSERT_EQ(workspace.document, end) << seed;
    }
}

TEST(SceneEdits, NamesLocksAndClipsAreNothingToDrawAgain) {
    Workspace workspace{test::busyDocument(), {}};
    History history;
    for (const Action& action :
         {rename(workspace.document, 2, "x"), setLocked(workspace.document, 2, true),
          addClip(workspace.document, 0, 2)}) {
        const Changed changed = history.execute(workspace, action);
        EXPECT_TRUE(changed.notes && !changed.scene) << action.label;
        const Changed undone = history.undo(workspace);
        EXPECT_TRUE(undone.notes && !undone.scene) << action.label;
    }
    for (const Action& action :
         {setHidden(workspace.document, 3, true), moveObject(workspace.document, 3, {1, 2, 3}, 0),
          addObject(workspace.document, "new"), deleteNodes(workspace.document, std::array{3})}) {
        const Changed changed = history.execute(workspace, action);
        EXPECT_TRUE(changed.scene) << action.label;
        EXPECT_TRUE(history.undo(workspace).scene) << action.label;
    }
}

// By their names, which every edit here leaves alone.
TEST(SceneEdits, SayWhichIndexEachNodeHasAfterwards) {
    const Document start = test::busyDocument();
    std::vector<Action> actions{deleteNodes(start, std::array{1}),
                                mergeNodes(start, std::array{2, 3}, "one"),
                                addObject(start, "new")};
    for (int i = 1; i < static_cast<int>(start.nodes.size()); ++i) {
        if (start.nodes[static_cast<std::size_t>(i)].isGroup())
            actions.push_back(ungroup(start, i));
    }
    for (const Action& action : actions) {
        Workspace workspace{start, {}};
        History history;
        const Changed changed = history.execute(workspace, action);
        const std::vector<SceneNode> then = workspace.document.nodes;
        const Changed back = history.undo(workspace);
        for (int i = 0; i < static_cast<int>(start.nodes.size()); ++i) {
            const int now = changed.nodeNow(i);
            const std::string& name = start.nodes[static_cast<std::size_t>(i)].name;
            const auto found = std::ranges::find(then, name, &SceneNode::name);
            const auto index = static_cast<int>(found - then.begin());
            ASSERT_EQ(now, found == then.end() ? -1 : index) << action.label << ": " << name;
            if (now < 0) continue;
            EXPECT_EQ(back.nodeNow(now), i) << action.label << ": " << name;
        }
    }
}

}  // namespace
}  // namespace voxprite
