// The list of objects, the sockets' tool and playing, without a window.
#include <gmock/gmock.h>

#include "app/editor/session/object_selection.h"
#include "app/editor/session/playback.h"
#include "core/edit/frame_edits.h"
#include "core/edit/scene_edits.h"
#include "core/edit/socket_edits.h"
#include "core/svo/bake.h"
#include "tests/app/tool_hand.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// A plate of 40 x 40 x 1 voxels, seen from above; the socket tool in hand.
class SocketsOnAPlate : public test::ToolHand {
  protected:
    SocketsOnAPlate() {
        attachBox({{-20, -20, 0}, {20, 20, 1}}, 5);
        orbit.yawDegrees = 25.0;
        orbit.pitchDegrees = 55.0;
        orbit.target = worldFromVoxel({0, 0, 1});
        orbit.distance = 60.0;
        settings.tool = ToolKind::socket;
        start = session.document();
    }
    [[nodiscard]] glm::dvec3 place(std::size_t socket) const {
        return positionAt(session.document().sockets[socket], session.frame());
    }
    Document start;
};

TEST_F(SocketsOnAPlate, AClickPutsOneIntoTheMiddleOfAVoxelWithShiftOfItsFace) {
    click(faceOf({3, 4, 0}));
    ASSERT_EQ(session.document().sockets.size(), 1u);
    EXPECT_EQ(place(0), glm::dvec3(3.5, 4.5, 0.5));
    shift = true;
    click(faceOf({-10, 9, 0}));
    ASSERT_EQ(session.document().sockets.size(), 2u);
    EXPECT_EQ(place(1), glm::dvec3(-9.5, 9.5, 1.0));
    EXPECT_EQ(session.document().sockets[1].name, "Socket 2");
    // Beside the model there is nothing to fasten it to.
    click(faceOf({60, 60, 0}));
    EXPECT_EQ(session.document().sockets.size(), 2u);
    while (session.history().position() > 1) ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.document(), start);
}

TEST_F(SocketsOnAPlate, ADragMovesTheOneUnderTheHandInOneStep) {
    click(faceOf({3, 4, 0}));
    const std::size_t steps = session.history().position();
    drag({faceOf({3, 4, 0}), faceOf({5, 4, 0}), faceOf({8, -2, 0})});
    ASSERT_EQ(session.document().sockets.size(), 1u);
    EXPECT_EQ(place(0), glm::dvec3(8.5, -1.5, 0.5));
    EXPECT_EQ(session.history().position(), steps + 1);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(place(0), glm::dvec3(3.5, 4.5, 0.5));
}

TEST_F(SocketsOnAPlate, InOneFrameAloneWhenAskedTo) {
    click(faceOf({3, 4, 0}));
    ASSERT_TRUE(
        session.perform(*addFrame(session.document(), session.activeNode(), 0, NewFrame::held)));
    ASSERT_TRUE(session.setFrame(1));
    settings.socketsInThisFrame = true;
    drag({faceOf({3, 4, 0}), faceOf({9, 4, 0})});
    EXPECT_EQ(place(0), glm::dvec3(9.5, 4.5, 0.5));
    ASSERT_TRUE(session.setFrame(0));
    EXPECT_EQ(place(0), glm::dvec3(3.5, 4.5, 0.5));
}

class Objects : public testing::Test {
  protected:
    Objects() {
        for (const char* name : {"b", "c"}) {
            EXPECT_TRUE(session.perform(addObject(session.document(), name)));
        }
        const std::vector<int> nodes{1, 2};
        EXPECT_TRUE(session.perform(groupNodes(session.document(), nodes, "group")));
        objects.follow(session);
    }
    Session session;
    ObjectSelection objects;
};

TEST_F(Objects, WithoutAChoiceTheActiveOneIsMeant) {
    session.setActiveNode(2);
    EXPECT_THAT(objects.nodes(session), ElementsAre(2));
    EXPECT_TRUE(objects.isChosen(session, 2));
    EXPECT_EQ(objects.node(session), 2);
}

TEST_F(Objects, SeveralAreChosenAndAnObjectAmongThemIsEdited) {
    objects.choose(session, 1);
    objects.toggle(session, 3);
    EXPECT_EQ(session.activeNode(), 3);
    EXPECT_THAT(objects.nodes(session), UnorderedElementsAre(1, 3));
    objects.toggle(session, 3);
    EXPECT_THAT(objects.nodes(session), ElementsAre(1));
    EXPECT_EQ(session.activeNode(), 1);
    objects.toggle(session, 1);  // the last one stays
    EXPECT_THAT(objects.nodes(session), ElementsAre(1));
    objects.choose(session, 4);  // a group is no object
    EXPECT_EQ(session.activeNode(), 1);
    EXPECT_EQ(objects.node(session), 4);
    objects.follow(session);
    EXPECT_THAT(objects.nodes(session), ElementsAre(4));
}

TEST_F(Objects, AChoiceEndsWithTheTreeItWasMadeIn) {
    objects.choose(session, 1);
    objects.toggle(session, 3);
    session.setActiveNode(2);  // taken in hand in the view
    objects.follow(session);
    EXPECT_THAT(objects.nodes(session), ElementsAre(2));
    objects.choose(session, 3);
    const std::vector<int> gone{1};
    ASSERT_TRUE(session.perform(deleteNodes(session.document(), gone)));
    objects.follow(session);
    EXPECT_THAT(objects.nodes(session), ElementsAre(session.activeNode()));
}

TEST_F(Objects, ANameThatIsTypedEndsWithTheTree) {
    objects.choose(session, 4);
    objects.rename(4);
    ASSERT_TRUE(session.undo());
    objects.choose(session, 3);
    objects.follow(session);
    EXPECT_EQ(objects.renaming(), std::nullopt);
}

TEST_F(Objects, ANewSocketIsTheChosenOne) {
    ASSERT_TRUE(session.perform(addSocket(session.document(), {1, 2, 3})));
    objects.follow(session);
    EXPECT_EQ(objects.socket(), 0);
    ASSERT_TRUE(session.perform(addSocket(session.document(), {1, 2, 3})));
    objects.follow(session);
    EXPECT_EQ(objects.socket(), 1);
    objects.choose(session, 1);
    EXPECT_FALSE(objects.socket());
    objects.chooseSocket(1);
    ASSERT_TRUE(session.undo());
    objects.follow(session);
    EXPECT_FALSE(objects.socket());
}

// Names, locks and clips change no octree; everything else leaves it that of the document.
TEST_F(Objects, TheOctreeFollowsEverySceneEdit) {
    const auto current = [&] {
        const auto baked = bake(flatten(session.document(), session.frame()), session.bounds());
        const auto live = session.octree().canonical(session.bounds());
        return baked && live && *live == *baked;
    };
    const auto does = [&](Action action) {
        ASSERT_TRUE(session.perform(std::move(action)));
        EXPECT_TRUE(current());
    };
    does(makeAction("draw", VoxelPatch{0, {{{0, 0, 0}, 0, 3}, {{1, 2, 3}, 0, 4}}}));
    const std::uint64_t first = session.voxelRevision(0), second = session.voxelRevision(1);
    does(makeAction("draw", VoxelPatch{1, {{{5, 0, 0}, 0, 3}}}));
    EXPECT_EQ(session.voxelRevision(0), first);
    EXPECT_NE(session.voxelRevision(1), second);
    const std::uint64_t model = session.modelRevision();
    does(rename(session.document(), 1, "x"));
    does(setLocked(session.document(), 1, true));
    does(addClip(session.document(), 0, 0));
    does(addSocket(session.document(), {0, 0, 0}));
    EXPECT_EQ(session.modelRevision(), model);
    does(turnNode(session.document(), 1, 0, 2, 1));
    does(duplicateNode(session.document(), 4, Copy::linked));
    EXPECT_NE(session.modelRevision(), model);
    while (session.history().canUndo()) {
        ASSERT_TRUE(session.undo());
        EXPECT_TRUE(current());
    }
}

class Playing : public testing::Test {
  protected:
    Playing() {
        for (int frame = 0; frame < 3; ++frame) {
            EXPECT_TRUE(session.perform(
                *addFrame(session.document(), session.activeNode(), frame, NewFrame::empty)));
        }
    }
    void pass(double seconds) { ASSERT_TRUE(playback.advance(session, view, seconds)); }
    Session session;
    ViewSettings view;
    Playback playback;
};

TEST_F(Playing, AllFramesAtTheChosenRate) {
    view.framesPerSecond = 4.0;
    pass(1.0);
    EXPECT_EQ(session.frame(), 0);  // it does not play
    view.playing = true;
    for (const int frame : {1, 2, 3, 0, 1}) {
        pass(0.25);
        EXPECT_EQ(session.frame(), frame);
    }
    // A frame shown by hand is where it goes on.
    ASSERT_TRUE(session.setFrame(3));
    pass(0.2);
    EXPECT_EQ(session.frame(), 3);
    pass(0.1);
    EXPECT_EQ(session.frame(), 0);
}

TEST_F(Playing, AClipThatDoesNotLoopEndsAndBeginsAgain) {
    ASSERT_TRUE(session.perform(addClip(session.document(), 1, 2)));
    Clip clip = session.document().clips[0];
    clip.loop = false;
    clip.durationsMilliseconds = {100, 300};
    ASSERT_TRUE(session.perform(setClip(session.document(), 0, clip, 0)));
    playback.chooseClip(0);
    for (int round = 0; round < 2; ++round) {
        view.playing = true;
        pass(0.0);
        EXPECT_EQ(session.frame(), 1);
        pass(0.15);
        EXPECT_EQ(session.frame(), 2);
        EXPECT_TRUE(view.playing);
        pass(0.3);
        EXPECT_EQ(session.frame(), 2);
        EXPECT_FALSE(view.playing);
        pass(0.1);
    }
    // The clip goes; all frames are left.
    ASSERT_TRUE(session.perform(deleteClip(session.document(), 0)));
    EXPECT_FALSE(playback.clip(session.document()));
    EXPECT_EQ(playback.played(session, view).last, 3);
}

}  // namespace
}  // namespace voxprite::editor
