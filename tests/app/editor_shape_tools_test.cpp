// Shapes, faces, fills, the laser and the stamp, without a window: each against a model that the
// test computes by itself.
#include <cmath>

#include "core/edit/scene_edits.h"
#include "core/edit/selection.h"
#include "tests/app/tool_hand.h"

namespace voxprite::editor {
namespace {

// A block of 24 x 24 x 12 voxels whose top lies at z = 0, seen from above.
class ToolsOnABlock : public test::ToolHand {
  protected:
    ToolsOnABlock() {
        attachBox({{-12, -12, -12}, {12, 12, 0}}, 5);
        orbit.yawDegrees = 25.0;
        orbit.pitchDegrees = 50.0;
        orbit.target = worldFromVoxel({0, 0, 0});
        orbit.distance = 60.0;
        settings.colour = 9;
        start = made();
    }
    // The start with `colour` where it holds, in a box around the model.
    template <class Holds>
    [[nodiscard]] VoxelGrid with(std::uint8_t colour, const Holds& holds) const {
        VoxelGrid grid = start;
        for (int x = -20; x < 20; ++x) {
            for (int y = -20; y < 20; ++y) {
                for (int z = -20; z < 20; ++z) {
                    if (holds(x, y, z)) grid.set({x, y, z}, colour);
                }
            }
        }
        return grid;
    }
    void dragShape(ToolKind kind, glm::ivec3 from, glm::ivec3 to, double layers = 0.0) {
        settings.choose(kind);
        moveTo(faceOf(from));
        press();
        moveTo(faceOf(to));
        for (; layers >= 1.0; layers -= 1.0) {
            wheel = 1.0;
            frame({}, false, false);
        }
        release();
    }
    VoxelGrid start;
};

TEST_F(ToolsOnABlock, ABoxIsShownAndKeptByEnter) {
    dragShape(ToolKind::box, {-4, -3, -1}, {5, 6, -1}, 2);
    const auto inside = [](int x, int y, int z) {
        return x >= -4 && x <= 5 && y >= -3 && y <= 6 && z >= 0 && z <= 2;
    };
    EXPECT_TRUE(tools.busy());
    EXPECT_EQ(made(), start);
    EXPECT_EQ(shown(), with(9, inside));
    keep();
    EXPECT_EQ(made(), with(9, inside));
    EXPECT_FALSE(tools.busy());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(made(), start);
}

TEST_F(ToolsOnABlock, TheNextShapeKeepsTheLast) {
    dragShape(ToolKind::box, {-9, -9, -1}, {-7, -7, -1});
    // The press keeps the first box; the drag makes the next, in the frame after it.
    moveTo(faceOf({4, 4, -1}));
    press();
    moveTo(faceOf({4, 4, -1}));
    moveTo(faceOf({6, 5, -1}));
    release();
    const auto first = [](int x, int y, int z) {
        return x >= -9 && x <= -7 && y >= -9 && y <= -7 && z == 0;
    };
    EXPECT_EQ(made(), with(9, first));
    EXPECT_EQ(shown(), with(9, [&](int x, int y, int z) {
                  return first(x, y, z) || (x >= 4 && x <= 6 && y >= 4 && y <= 5 && z == 0);
              }));
    // Another tool keeps it, too.
    settings.choose(ToolKind::brush);
    moveTo({5, 5});
    EXPECT_EQ(session.history().position(), 3u);
    EXPECT_EQ(made(), shown());
}

TEST_F(ToolsOnABlock, HandlesAndFiguresResize) {
    dragShape(ToolKind::box, {-4, -3, -1}, {3, 4, -1});
    // The handle of the upper side, dragged up by five voxels.
    const glm::dvec2 top = camera().project(worldFromVoxel({0.0, 1.0, 1.0})).screenPx;
    const glm::dvec2 higher = camera().project(worldFromVoxel({0.0, 1.0, 6.0})).screenPx;
    drag({top, higher});
    auto figures = tools.tool()->figures();
    ASSERT_EQ(figures.size(), 3u);
    EXPECT_EQ(figures[0].value, 8);
    EXPECT_EQ(figures[1].value, 8);
    EXPECT_EQ(figures[2].value, 6);
    tools.tool()->setFigure(0, 3);
    moveTo({5, 5});
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return x >= -4 && x <= -2 && y >= -3 && y <= 4 && z >= 0 && z <= 5;
              }));
}

TEST_F(ToolsOnABlock, TheSideThatIsNotDraggedStays) {
    dragShape(ToolKind::box, {3, 4, -1}, {-4, -3, -1});  // from the far corner to the near one
    const glm::dvec2 side = camera().project(worldFromVoxel({4.0, 1.0, 0.5})).screenPx;
    const glm::dvec2 farther = camera().project(worldFromVoxel({8.0, 1.0, 0.5})).screenPx;
    drag({side, farther});
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return x >= -4 && x <= 7 && y >= -3 && y <= 4 && z == 0;
              }));
}

TEST_F(ToolsOnABlock, ErasingAndPaintingShapesGoInward) {
    settings.mode = EditMode::erase;
    dragShape(ToolKind::box, {-4, -3, -1}, {5, 6, -1}, 3);
    keep();
    EXPECT_EQ(made(), with(0, [](int x, int y, int z) {
                  return x >= -4 && x <= 5 && y >= -3 && y <= 6 && z <= -1 && z >= -4;
              }));
    ASSERT_TRUE(session.undo());
    settings.mode = EditMode::paint;
    dragShape(ToolKind::box, {-4, -3, -1}, {5, 6, -1}, 1);
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return x >= -4 && x <= 5 && y >= -3 && y <= 6 && z <= -1 && z >= -2;
              }));
}

TEST_F(ToolsOnABlock, TheModeCanChangeUntilItIsKept) {
    dragShape(ToolKind::box, {-2, -2, -1}, {2, 2, -1});
    settings.mode = EditMode::erase;
    moveTo({5, 5});
    // It stands over the face, where there is nothing to erase; grown down it cuts.
    EXPECT_EQ(shown(), start);
    settings.mode = EditMode::attach;
    settings.colour = 44;
    moveTo({6, 5});
    keep();
    EXPECT_EQ(made().get({0, 0, 0}), 44);
}

TEST_F(ToolsOnABlock, SpheresEllipsoidsAndCylindersFillTheirBox) {
    dragShape(ToolKind::sphere, {-4, -4, -1}, {4, 2, -1});
    keep();
    // Nine wide, on the face: x -4...4, y -4...4, z 0...8.
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return z >= 0 && 4 * (x * x + y * y + (z - 4) * (z - 4)) <= 81;
              }));
    ASSERT_TRUE(session.undo());

    dragShape(ToolKind::ellipse, {-5, -3, -1}, {5, 3, -1});
    tools.tool()->setFigure(2, 5);
    moveTo({5, 5});
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  const double fx = 2.0 * x / 11, fy = 2.0 * y / 7, fz = 2.0 * (z - 2) / 5;
                  return z >= 0 && fx * fx + fy * fy + fz * fz <= 1.0 + 1e-12;
              }));
    ASSERT_TRUE(session.undo());

    dragShape(ToolKind::cylinder, {-4, -4, -1}, {4, 4, -1}, 6);
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return z >= 0 && z < 7 && 4 * (x * x + y * y) <= 81;
              }));
}

TEST_F(ToolsOnABlock, HollowShapesHaveAWallOfOne) {
    settings.options.hollow = true;
    dragShape(ToolKind::box, {-4, -3, -1}, {5, 6, -1}, 4);
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  const bool in = x >= -4 && x <= 5 && y >= -3 && y <= 6 && z >= 0 && z <= 4;
                  return in && (x == -4 || x == 5 || y == -3 || y == 6 || z == 0 || z == 4);
              }));
}

TEST_F(ToolsOnABlock, LinesJoinTheirEnds) {
    dragShape(ToolKind::line, {-9, -7, -1}, {9, 2, -1});
    EXPECT_EQ(tools.tool()->figures()[0].value, 18);
    keep();
    EXPECT_EQ(made().get({-9, -7, 0}), 9);
    EXPECT_EQ(made().get({9, 2, 0}), 9);
    // One voxel a step along x, the nearest to the true line.
    EXPECT_EQ(made().solidCount(), start.solidCount() + 19);
    for (int x = -9; x <= 9; ++x) {
        const double y = -7.0 + (x + 9) * 0.5;
        const bool low = made().get({x, static_cast<int>(std::floor(y)), 0}) == 9;
        const bool high = made().get({x, static_cast<int>(std::ceil(y)), 0}) == 9;
        EXPECT_TRUE(low || high) << x;
    }
}

TEST_F(ToolsOnABlock, MirrorsMakeTheOtherHalfOfAShape) {
    settings.options.symmetry.on = {true, false, false};
    settings.options.symmetry.planeDoubled = {0, 0, 0};
    dragShape(ToolKind::box, {2, 3, -1}, {5, 4, -1}, 1);
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return ((x >= 2 && x <= 5) || (x >= -6 && x <= -3)) && y >= 3 && y <= 4 &&
                         z >= 0 && z <= 1;
              }));
}

TEST_F(ToolsOnABlock, UndoneByEscapeAndTooLargeIsRefused) {
    dragShape(ToolKind::box, {2, 3, -1}, {5, 4, -1});
    tools.cancel(session);
    EXPECT_EQ(shown(), start);
    dragShape(ToolKind::box, {2, 3, -1}, {5, 4, -1});
    for (std::size_t i = 0; i < 3; ++i) tools.tool()->setFigure(i, 1024);
    moveTo({5, 5});
    tools.finishPreview(session);
    moveTo({5, 5});
    EXPECT_NE(refusal, "");
    EXPECT_EQ(shown(), start);
    tools.cancel(session);
    EXPECT_EQ(made(), start);
}

TEST_F(ToolsOnABlock, AShapeGoesWithTheModelThatItWasMadeFor) {
    ASSERT_TRUE(session.perform(addObject(session.document(), "new")));
    session.setActiveNode(2);
    dragShape(ToolKind::box, {2, 3, -1}, {5, 4, -1});
    EXPECT_NE(shown(), start);
    ASSERT_TRUE(session.undo());  // there is no such model any more
    moveTo({5, 5});
    EXPECT_FALSE(tools.busy());
    EXPECT_EQ(made(), start);
}

TEST_F(ToolsOnABlock, FacesArePulledPushedAndTyped) {
    // A step of another colour on one half of the top.
    attachBox({{0, -12, 0}, {12, 12, 2}}, 6);
    start = made();
    settings.choose(ToolKind::face);
    settings.options.sameColour = false;
    const auto low = [](int x, int y) { return x >= -12 && x < 0 && y >= -12 && y < 12; };
    // Up by three, dragged; the layers take the colour of their face.
    moveTo(faceOf({-6, 0, -1}));
    press();
    moveTo(camera().project(worldFromVoxel({-5.5, 0.5, 3.0})).screenPx);
    release();
    EXPECT_EQ(tools.tool()->figures()[0].value, 3);
    EXPECT_EQ(shown(), with(5, [&](int x, int y, int z) { return low(x, y) && z >= 0 && z < 3; }));
    tools.tool()->setFigure(0, -4);
    moveTo({5, 5});
    keep();
    EXPECT_EQ(made(), with(0, [&](int x, int y, int z) { return low(x, y) && z < 0 && z >= -4; }));
    ASSERT_TRUE(session.undo());
    // A click is one layer, the way of the mode.
    click(faceOf({-6, 0, -1}));
    keep();
    EXPECT_EQ(made(), with(5, [&](int x, int y, int z) { return low(x, y) && z == 0; }));
    ASSERT_TRUE(session.undo());
    settings.mode = EditMode::erase;
    click(faceOf({-6, 0, -1}));
    keep();
    EXPECT_EQ(made(), with(0, [&](int x, int y, int z) { return low(x, y) && z == -1; }));
    ASSERT_TRUE(session.undo());
    settings.mode = EditMode::paint;
    click(faceOf({-6, 0, -1}));
    EXPECT_EQ(made(), with(9, [&](int x, int y, int z) { return low(x, y) && z == -1; }));
}

TEST_F(ToolsOnABlock, FacesOfOneColourStopAtTheNext) {
    settings.mode = EditMode::paint;
    dragShape(ToolKind::box, {-12, -12, -1}, {-1, 11, -1});
    keep();
    start = made();
    settings.mode = EditMode::attach;
    settings.options.sameColour = true;
    settings.choose(ToolKind::face);
    click(faceOf({-6, 0, -1}));
    keep();
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return x >= -12 && x < 0 && y >= -12 && y < 12 && z == 0;
              }));
}

TEST_F(ToolsOnABlock, FillRecoloursWhatIsConnected) {
    // A bar on the top that touches the block by faces, and two voxels that touch by an edge.
    attachBox({{-5, 0, 0}, {5, 1, 1}}, 6);
    attachBox({{5, 1, 0}, {6, 2, 1}}, 6);
    start = made();
    settings.choose(ToolKind::fill);
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(made(),
              with(9, [](int x, int y, int z) { return x >= -5 && x < 5 && y == 0 && z == 0; }));
    ASSERT_TRUE(session.undo());
    settings.options.neighbours = Neighbours::twentySix;
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(made(), with(9, [](int x, int y, int z) {
                  return (x >= -5 && x < 5 && y == 0 && z == 0) || (x == 5 && y == 1 && z == 0);
              }));
    ASSERT_TRUE(session.undo());
    settings.mode = EditMode::erase;
    settings.options.sameColour = false;
    click(faceOf({0, 0, 0}));
    EXPECT_TRUE(made().empty());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(made(), start);
}

TEST_F(ToolsOnABlock, PlaneFillClosesAnOutline) {
    settings.options.hollow = true;
    dragShape(ToolKind::box, {-6, -6, -1}, {6, 6, -1}, 2);
    keep();
    settings.mode = EditMode::erase;
    settings.options.hollow = false;
    dragShape(ToolKind::box, {-5, -5, 2}, {5, 5, 2}, 1);  // the lid and what is under it
    keep();
    start = made();
    ASSERT_EQ(start.get({0, 0, 1}), 0);
    ASSERT_EQ(start.get({-6, 0, 1}), 9);
    settings.mode = EditMode::attach;
    settings.choose(ToolKind::planeFill);
    settings.colour = 44;
    ASSERT_EQ(pickAt(faceOf({0, 0, 0}))->voxel, glm::ivec3(0, 0, 0));
    click(faceOf({0, 0, 0}));
    EXPECT_EQ(made(), with(44, [](int x, int y, int z) {
                  return x > -6 && x < 6 && y > -6 && y < 6 && z == 1;
              }));
}

TEST_F(ToolsOnABlock, LaserBurnsThroughEverythingAlongTheRay) {
    settings.choose(ToolKind::laser);
    orbit.yawDegrees = 0.0;
    orbit.pitchDegrees = 90.0;
    // Straight down through the middle of the view.
    orbit.target = worldFromVoxel({3.5, 2.5, 0.0});
    click({320, 240});
    EXPECT_EQ(made(), with(0, [](int x, int y, int) { return x == 3 && y == 2; }));
    ASSERT_TRUE(session.undo());
    settings.options.tipEdge = 3;
    click({320, 240});
    EXPECT_EQ(made(), with(0, [](int x, int y, int) {
                  return std::abs(x - 3) <= 1 && std::abs(y - 2) <= 1;
              }));
}

TEST_F(ToolsOnABlock, StampPutsACopyOnTheFace) {
    settings.choose(ToolKind::stamp);
    moveTo(faceOf({0, 0, -1}));
    press();
    EXPECT_NE(refusal, "");  // there is nothing to stamp yet
    release();
    VoxelGrid piece;
    piece.set({100, 50, 7}, 3);
    piece.set({101, 50, 7}, 4);
    piece.set({102, 50, 9}, 6);
    session.setClip(copyVoxels(piece, selectAll(piece)));
    moveTo(faceOf({1, 1, -1}));
    click(faceOf({0, 0, -1}));
    VoxelGrid expected = start;
    expected.set({-1, 0, 0}, 3);
    expected.set({0, 0, 0}, 4);
    expected.set({1, 0, 2}, 6);
    EXPECT_EQ(made(), expected);
    ASSERT_TRUE(session.undo());
    settings.options.symmetry.on = {false, true, false};
    settings.options.symmetry.planeDoubled = {0, 5, 0};
    click(faceOf({0, 0, -1}));
    expected.set({-1, 4, 0}, 3);
    expected.set({0, 4, 0}, 4);
    expected.set({1, 4, 2}, 6);
    EXPECT_EQ(made(), expected);
}

}  // namespace
}  // namespace voxprite::editor
