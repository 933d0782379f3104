#include "core/edit/frame_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/edit/socket_edits.h"
#include "core/model/entity_voxels.h"
#include "tests/support/edits.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::after;
using testing::ElementsAre;

Document after(const Document& document, Result<Action> action) {
    if (!action) {
        ADD_FAILURE() << action.error().message;
        return document;
    }
    return after(document, std::move(*action));
}

std::vector<test::VoxelMap> framesOf(const Document& document) {
    std::vector<test::VoxelMap> frames;
    for (int frame = 0; frame < frameCount(document); ++frame) {
        frames.push_back(test::mapOf(flatten(document, frame)));
    }
    return frames;
}

// The frames of the whole document, moved about as the edit says, independently of any track.
TEST(FrameEdits, EveryObjectAndSocketFollows) {
    Document before = test::busyDocument();
    before.sockets = {Socket{"hand", {{0, {1, 2, 3}}}},
                      Socket{"tip", {{0, {0, 0, 0}}, {2, {5, 0, 0}}, {3, {7, 0, 0}}}}};
    const std::vector<test::VoxelMap> frames = framesOf(before);
    const auto tips = [](const Document& document) {
        std::vector<double> xs;
        for (int f = 0; f < frameCount(document); ++f) {
            xs.push_back(positionAt(document.sockets[1], f).x);
        }
        return xs;
    };
    ASSERT_EQ(frames.size(), 5u);
    for (int f = 0; f < 5; ++f) {
        std::vector<test::VoxelMap> expected = frames;
        expected.erase(expected.begin() + f);
        EXPECT_EQ(framesOf(after(before, deleteFrame(before, f))), expected) << f;

        expected = frames;
        expected.insert(expected.begin() + f, frames[static_cast<std::size_t>(f)]);
        for (const NewFrame what : {NewFrame::held, NewFrame::copy}) {
            EXPECT_EQ(framesOf(after(before, addFrame(before, 7, f, what))), expected) << f;
        }
        for (int to = 0; to < 5; ++to) {
            expected = frames;
            expected.erase(expected.begin() + f);
            expected.insert(expected.begin() + to, frames[static_cast<std::size_t>(f)]);
            EXPECT_EQ(framesOf(after(before, moveFrame(before, f, to))), expected) << f << to;
        }
    }
    EXPECT_THAT(tips(after(before, deleteFrame(before, 2))), ElementsAre(0, 0, 7, 7));
    EXPECT_THAT(tips(after(before, moveFrame(before, 2, 0))), ElementsAre(5, 0, 0, 7, 7));
    EXPECT_THAT(tips(after(before, addFrame(before, 7, 2, NewFrame::held))),
                ElementsAre(0, 0, 5, 5, 7, 7));
}

TEST(FrameEdits, ANewFrameIsACopyOfItsOwnOrTheSameOrEmpty) {
    const Document before = test::documentOf(test::figure());
    const Document copy = after(before, addFrame(before, 1, 0, NewFrame::copy));
    EXPECT_THAT(copy.nodes[1].models, ElementsAre(ModelKey{0, 0}, ModelKey{1, 1}));
    EXPECT_EQ(copy.models[1], copy.models[0]);

    const Document held = after(before, addFrame(before, 1, 0, NewFrame::held));
    EXPECT_EQ(held.models.size(), 1u);
    EXPECT_EQ(frameCount(held), 2);
    EXPECT_EQ(modelAt(held.nodes[1], 1), 0);

    const Document empty = after(copy, addFrame(copy, 1, 0, NewFrame::empty));
    EXPECT_EQ(frameCount(empty), 3);
    EXPECT_TRUE(empty.models[static_cast<std::size_t>(modelAt(empty.nodes[1], 1))].voxels.empty());
    EXPECT_EQ(modelAt(empty.nodes[1], 2), 1);
    // The last of many: a copy that looks the same still counts as a frame.
    const Document last = after(held, addFrame(held, 1, 1, NewFrame::held));
    EXPECT_EQ(frameCount(last), 3);
}

TEST(FrameEdits, TheOnlyFrameStays) {
    const Document document = test::documentOf(test::figure());
    const Result<Action> action = deleteFrame(document, 0);
    ASSERT_FALSE(action);
    EXPECT_EQ(action.error().message, "the only frame cannot be deleted");
}

TEST(FrameEdits, ClipsKeepTheirFrames) {
    Document before = test::busyDocument();
    before.clips = {Clip{"a", 0, 1, 8.0, true, {10, 20}}, Clip{"b", 2, 2, 8.0, true, {}},
                    Clip{"c", 1, 4, 8.0, true, {1, 2, 3, 4}}};
    const Document more = after(before, addFrame(before, 3, 1, NewFrame::held));
    EXPECT_THAT(more.clips, ElementsAre(Clip{"a", 0, 2, 8.0, true, {10, 20, 20}},
                                        Clip{"b", 3, 3, 8.0, true, {}},
                                        Clip{"c", 1, 5, 8.0, true, {1, 1, 2, 3, 4}}));
    const Document fewer = after(before, deleteFrame(before, 2));
    EXPECT_THAT(fewer.clips, ElementsAre(Clip{"a", 0, 1, 8.0, true, {10, 20}},
                                         Clip{"c", 1, 3, 8.0, true, {1, 3, 4}}));
    const Document moved = after(before, moveFrame(before, 4, 1));
    EXPECT_EQ(moved.clips[2], (Clip{"c", 1, 4, 8.0, true, {4, 1, 2, 3}}));
    EXPECT_EQ(moved.clips[0], before.clips[0]);
}

TEST(FrameEdits, ClipsHaveNamesOfTheirOwnAndADurationAFrame) {
    Document document = test::busyDocument();
    document = after(document, addClip(document, 0, 3));
    document = after(document, addClip(document, 1, 1));
    EXPECT_EQ(document.clips[2].name, "Clip");
    EXPECT_EQ(document.clips[3].name, "Clip 2");
    Clip longer = document.clips[2];
    longer.durationsMilliseconds = {100, 50};
    document = after(document, setClip(document, 2, longer, 0));
    EXPECT_THAT(document.clips[2].durationsMilliseconds, ElementsAre(100, 50, 50, 50));
    document = after(document, deleteClip(document, 2));
    EXPECT_EQ(document.clips.size(), 3u);
    EXPECT_EQ(document.clips[2].name, "Clip 2");
}

TEST(FrameEdits, AFrameKeepsItsLengthWhereTheClipBeginsElsewhere) {
    Document document = test::busyDocument();
    document.clips = {Clip{"a", 1, 3, 8.0, true, {100, 200, 300}}};
    const auto beginAt = [&](int first) {
        Clip clip = document.clips[0];
        clip.first = first;
        document = after(document, setClip(document, 0, clip, 0));
        return document.clips[0].durationsMilliseconds;
    };
    EXPECT_THAT(beginAt(2), ElementsAre(200, 300));
    EXPECT_THAT(beginAt(0), ElementsAre(200, 200, 200, 300));
    EXPECT_THAT(beginAt(3), ElementsAre(300));
    // Beyond all that it had.
    Clip clip{"a", 4, 4, 8.0, true, document.clips[0].durationsMilliseconds};
    document = after(document, setClip(document, 0, clip, 0));
    EXPECT_EQ(document.clips[0], clip);
    // Lengths that come with it are its own.
    clip = {"a", 1, 2, 8.0, true, {7, 8}};
    document = after(document, setClip(document, 0, clip, 0));
    EXPECT_EQ(document.clips[0], clip);
}

TEST(SocketEdits, MoveInOneFrameOrInAll) {
    Document document = test::busyDocument();
    document.sockets.clear();
    document = after(document, addSocket(document, {1, 2, 3}));
    document = after(document, addSocket(document, {4, 5, 6}));
    EXPECT_EQ(document.sockets[0].name, "Socket");
    EXPECT_EQ(document.sockets[1].name, "Socket 2");
    document = after(document, renameSocket(document, 0, "hand"));

    const auto places = [&] {
        std::vector<double> xs;
        for (int f = 0; f < 5; ++f) xs.push_back(positionAt(document.sockets[0], f).x);
        return xs;
    };
    document = after(document, moveSocket(document, 0, 2, {9, 2, 3}, SocketReach::thisFrame, 0));
    EXPECT_THAT(places(), ElementsAre(1, 1, 9, 1, 1));
    document = after(document, moveSocket(document, 0, 2, {10, 2, 3}, SocketReach::allFrames, 0));
    EXPECT_THAT(places(), ElementsAre(2, 2, 10, 2, 2));
    document = after(document, moveSocket(document, 0, 0, {5, 2, 3}, SocketReach::thisFrame, 0));
    document = after(document, moveSocket(document, 0, 4, {6, 2, 3}, SocketReach::thisFrame, 0));
    EXPECT_THAT(places(), ElementsAre(5, 2, 10, 2, 6));
    document = after(document, deleteSocket(document, 0));
    EXPECT_EQ(document.sockets.size(), 1u);
}

TEST(SocketEdits, ADragIsOneStep) {
    Workspace workspace{test::documentOf(test::figure()), {}};
    History history;
    static_cast<void>(history.execute(workspace, addSocket(workspace.document, {0, 0, 0})));
    for (int x = 1; x < 10; ++x) {
        const Changed changed = history.execute(
            workspace, moveSocket(workspace.document, 0, 0, {x, 0, 0}, SocketReach::allFrames, 7));
        EXPECT_TRUE(changed.sockets && !changed.scene);
    }
    EXPECT_EQ(history.position(), 2u);
    static_cast<void>(history.undo(workspace));
    EXPECT_EQ(workspace.document.sockets[0].positions[0].positionVoxels, glm::dvec3(0));
    EXPECT_GT(history.bytes(), sizeof(Socket));
}

}  // namespace
}  // namespace voxprite
