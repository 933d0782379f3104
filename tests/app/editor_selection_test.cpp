// Selecting, and what is done with what is selected, without a window: against sets and models that
// the test computes voxel by voxel.
#include <array>
#include <functional>
#include <map>
#include <tuple>

#include "app/editor/session/selection_edits.h"
#include "app/editor/tools/select_tools.h"
#include "core/edit/frame_edits.h"
#include "core/edit/scene_edits.h"
#include "core/model/voxel_grid.h"
#include "tests/app/tool_hand.h"
#include "tests/support/must.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

using Place = std::tuple<int, int, int>;
using Cells = std::map<Place, std::uint8_t>;

Place placeOf(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}
Cells cellsOf(const VoxelGrid& grid) {
    Cells cells;
    grid.forEachSolid([&](glm::ivec3 v, std::uint8_t value) { cells[placeOf(v)] = value; });
    return cells;
}

class Selecting : public test::ToolHand {
  protected:
    Selecting() {
        // Two colours in columns, and a smaller block on top of it.
        attachBox({{-12, -12, -12}, {12, 12, 0}}, 5);
        attachBox({{-2, -2, 0}, {3, 4, 5}}, 7);
        std::vector<glm::ivec3> dots;
        test::Random random(3);
        for (int i = 0; i < 900; ++i) {
            dots.push_back({random.between(-12, 11), random.between(-12, 11), -1});
        }
        carryOut(
            {{makeAction("dots", patchVoxels(session.document(), 0, dots, EditMode::paint, 8))},
             ""});
        orbit.yawDegrees = 25.0;
        orbit.pitchDegrees = 50.0;
        orbit.target = worldFromVoxel({0, 0, 0});
        orbit.distance = 60.0;
        settings.colour = 9;
        start = cellsOf(made());
        steps = session.history().position();
    }
    [[nodiscard]] Cells selected() const { return cellsOf(session.selection().voxels().grid()); }
    using Holds = std::function<bool(int x, int y, int z)>;
    // The voxels of the start for which it holds; all have the value 1, as a selection's have.
    [[nodiscard]] Cells those(const Holds& holds) const {
        Cells cells;
        for (const auto& [at, value] : start) {
            const auto [x, y, z] = at;
            if (holds(x, y, z)) cells[at] = 1;
        }
        return cells;
    }
    void selectOnly(const Holds& holds) {
        VoxelSet set;
        for (const auto& [at, value] : those(holds)) {
            const auto [x, y, z] = at;
            set.insert(glm::ivec3(x, y, z));
        }
        session.selection().select(0 + session.activeNode(), 0, set);
    }
    // The start without the voxels that hold, and with `mapped` of each of them.
    [[nodiscard]] Cells moved(const Holds& holds,
                              const std::function<Place(int, int, int)>& mapped) const {
        Cells after = start;
        for (const auto& [at, value] : those(holds)) after.erase(at);
        for (const auto& [at, value] : those(holds)) {
            const auto [x, y, z] = at;
            after[mapped(x, y, z)] = start.at(at);
        }
        return after;
    }
    // What floats is shown and not made; then it is put down in one step, and undone.
    void expectFloats(const Cells& after) {
        settings.choose(ToolKind::move);
        moveTo({1, 1});
        EXPECT_TRUE(tools.busy());
        EXPECT_EQ(cellsOf(made()), start);
        EXPECT_EQ(cellsOf(shown()), after);
        const Cells before = selected();
        keep();
        EXPECT_EQ(session.history().position(), steps + 1);
        EXPECT_EQ(cellsOf(made()), after);
        ASSERT_TRUE(session.undo());
        EXPECT_EQ(cellsOf(made()), start);
        EXPECT_EQ(selected(), before);
    }
    void expectMade(Result<Action> action, const Cells& after) {
        ASSERT_TRUE(action) << action.error().message;
        ASSERT_TRUE(session.perform(std::move(*action)));
        EXPECT_EQ(session.history().position(), steps + 1);
        EXPECT_EQ(cellsOf(made()), after);
        ASSERT_TRUE(session.undo());
        EXPECT_EQ(cellsOf(made()), start);
    }
    Cells start;
    std::size_t steps = 0;
};

bool isTower(int x, int y, int z) {
    return z >= 0 && x >= -2 && x < 3 && y >= -2 && y < 4;
}

TEST_F(Selecting, ABoxIsDraggedAddedToTakenFromAndResized) {
    settings.choose(ToolKind::selectBox);
    drag({faceOf({-9, -8, -1}), faceOf({-5, -6, -1})});
    const auto first = [](int x, int y, int z) {
        return x >= -9 && x <= -5 && y >= -8 && y <= -6 && z == -1;
    };
    EXPECT_EQ(selected(), those(first));
    EXPECT_FALSE(tools.busy());
    ASSERT_EQ(tools.tool()->figures().size(), 3u);
    tools.tool()->setFigure(0, 2);
    moveTo({1, 1});
    EXPECT_EQ(selected(), those([&](int x, int y, int z) { return first(x, y, z) && x <= -8; }));
    tools.tool()->setFigure(0, 5);
    moveTo({1, 1});

    shift = true;
    drag({faceOf({-6, -7, -1}), faceOf({-3, -4, -1})});
    const auto second = [](int x, int y, int z) {
        return x >= -6 && x <= -3 && y >= -7 && y <= -4 && z == -1;
    };
    EXPECT_EQ(selected(),
              those([&](int x, int y, int z) { return first(x, y, z) || second(x, y, z); }));
    alt = true;
    drag({faceOf({-7, -8, -1}), faceOf({-4, -7, -1})});
    EXPECT_EQ(selected(), those([&](int x, int y, int z) {
                  const bool third = x >= -7 && x <= -4 && y >= -8 && y <= -7;
                  return (first(x, y, z) || second(x, y, z)) && !third;
              }));
    EXPECT_EQ(settings.colour, 9);  // Alt has picked no colour
    shift = alt = false;
    click({2, 2});  // beside the model
    EXPECT_TRUE(session.selection().empty());
    EXPECT_EQ(session.history().position(), steps);
}

// Its figures would select in another object, or elsewhere in this one.
TEST_F(Selecting, ABoxGoesWhenItsObjectGetsAnotherIndexOrMoves) {
    const int lower = session.activeNode();
    ASSERT_TRUE(session.perform(addObject(session.document(), "other")));
    const IBox plate{{-9, -9, 0}, {-5, -5, 1}};
    ASSERT_TRUE(session.perform(
        makeAction("plate", patchBox(session.document(), 1, plate, EditMode::attach, 6))));
    settings.choose(ToolKind::selectBox);
    drag({faceOf({-9, -9, 0}), faceOf({-6, -6, 0})});
    ASSERT_EQ(session.selection().node(), lower + 1);
    ASSERT_EQ(session.selection().voxels().count(), 16u);
    ASSERT_TRUE(session.perform(deleteNodes(session.document(), std::array{lower})));
    tools.tool()->setFigure(0, 2);
    moveTo({1, 1});
    EXPECT_EQ(session.selection().node(), lower);
    EXPECT_EQ(session.selection().voxels().count(), 16u);
    EXPECT_TRUE(tools.tool()->figures().empty());
    EXPECT_TRUE(chosenVoxels(session));

    drag({faceOf({-8, -8, 0}), faceOf({-6, -6, 0})});
    ASSERT_EQ(session.selection().voxels().count(), 9u);
    ASSERT_TRUE(session.perform(moveObject(session.document(), lower, {5, 0, 0}, 0)));
    tools.tool()->setFigure(0, 2);
    moveTo({1, 1});
    EXPECT_EQ(session.selection().voxels().count(), 9u);
    EXPECT_TRUE(tools.tool()->figures().empty());
}

TEST_F(Selecting, ARectangleTakesWhatItsMiddleIsSeenIn) {
    settings.choose(ToolKind::selectRectangle);
    const glm::dvec2 a(211.3, 150.7), b(402.1, 333.9);
    for (const bool orthographic : {false, true}) {
        orbit.orthographic = orthographic;
        drag({a, {300, 200}, b});
        EXPECT_EQ(selected(), those([&](int x, int y, int z) {
                      const auto at =
                          camera().project(worldFromVoxel(glm::dvec3(x, y, z) + 0.5)).screenPx;
                      return at.x >= a.x && at.x <= b.x && at.y >= a.y && at.y <= b.y;
                  }));
        EXPECT_GT(selected().size(), 500u);
    }
    settings.options.inSight = true;
    drag({b, a});
    Cells seen;
    for (double y = a.y + 0.5; y < b.y; ++y) {
        for (double x = a.x + 0.5; x < b.x; ++x) {
            const auto hit = pickAt({x, y});
            if (hit && !hit->ground) seen[placeOf(hit->voxel)] = 1;
        }
    }
    EXPECT_EQ(selected(), seen);
    click({300, 200});
    EXPECT_TRUE(session.selection().empty());
}

TEST_F(Selecting, TheWandTakesWhatTouchesAndHasTheColour) {
    settings.choose(ToolKind::wand);
    settings.options.sameColour = true;
    click(faceOf({0, 0, 4}));
    EXPECT_EQ(selected(), those(isTower));
    settings.options.sameColour = false;
    click(faceOf({0, 0, 4}));
    EXPECT_EQ(selected(), those([](int, int, int) { return true; }));
    ASSERT_TRUE(selectColour(session, 8));
    EXPECT_EQ(selected(), those([&](int x, int y, int z) { return start.at({x, y, z}) == 8; }));
    ASSERT_TRUE(invertSelection(session));
    EXPECT_EQ(selected(), those([&](int x, int y, int z) { return start.at({x, y, z}) != 8; }));
    ASSERT_TRUE(selectEverything(session));
    EXPECT_EQ(selected().size(), start.size());
    EXPECT_FALSE(selectColour(session, 200));
}

TEST_F(Selecting, TheWandShowsWhatAClickWouldTake) {
    settings.choose(ToolKind::wand);
    settings.options.sameColour = true;
    // A floor of more blocks than the pointer waits for.
    attachBox({{-184, -184, -13}, {184, 184, -12}}, 6);
    const auto shownBox = [&] { return dynamic_cast<const WandTool&>(*tools.tool()).shownBox(); };
    IBox tower{{-2, -2, 0}, {3, 4, 5}};
    for (const glm::ivec3 voxel : {glm::ivec3(0, 0, 4), glm::ivec3(2, 3, 4)}) {
        moveTo(faceOf(voxel));
        EXPECT_EQ(shownBox(), tower);
    }
    moveTo(faceOf({-8, -8, -1}));
    EXPECT_NE(shownBox(), tower);
    EXPECT_FALSE(shownBox().empty());
    moveTo(faceOf({0, 0, 4}));
    EXPECT_EQ(shownBox(), tower);
    // What has changed is looked at again.
    attachBox({{3, 0, 4}, {4, 1, 5}}, 7);
    tower.max.x = 4;
    moveTo(faceOf({0, 0, 4}));
    EXPECT_EQ(shownBox(), tower);

    moveTo(faceOf({16, -16, -13}));
    EXPECT_TRUE(shownBox().empty());
    click(faceOf({16, -16, -13}));
    EXPECT_EQ(session.selection().voxels(), VoxelSet(IBox{{-184, -184, -13}, {184, 184, -12}}));
}

TEST_F(Selecting, DraggedVoxelsFloatUntilTheyArePutDown) {
    selectOnly(isTower);
    settings.choose(ToolKind::move);
    moveTo(faceOf({-1, 2, 4}));
    press();
    moveTo(faceOf({4, -5, 4}));
    release();
    const Cells after = moved(isTower, [](int x, int y, int z) { return Place{x + 5, y - 7, z}; });
    EXPECT_EQ(cellsOf(shown()), after);
    EXPECT_EQ(cellsOf(made()), start);
    tools.cancel(session);
    EXPECT_FALSE(tools.busy()) << "an undo that follows at once takes back a step";
    moveTo({3, 3});
    EXPECT_EQ(cellsOf(shown()), start);
    EXPECT_EQ(selected(), those(isTower));

    // Again, and put down by a click beside it.
    drag({faceOf({-1, 2, 4}), faceOf({4, -5, 4})});
    moveTo({2, 2});
    press();
    release();
    EXPECT_EQ(cellsOf(made()), after);
    EXPECT_EQ(selected().size(), those(isTower).size());
    EXPECT_EQ(selected().count({4 + 5, 0, 0}), 0u);
    EXPECT_EQ(selected().count({2 + 5, 3 - 7, 4}), 1u);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(cellsOf(made()), start);
    EXPECT_EQ(selected(), those(isTower));
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(cellsOf(made()), after);
    EXPECT_EQ(selected().count({2 + 5, 3 - 7, 4}), 1u);
}

TEST_F(Selecting, NothingThatWasMovedOverIsLostBeforeItIsPutDown) {
    selectOnly(isTower);
    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    // Down into the block, and out of it again.
    for (const int z : {-3, -3, 2, 1, 7}) {
        session.selection().changeFloating([&](Floating& f) { f.moveBy({0, 0, z}); });
        settings.choose(ToolKind::move);
        moveTo({1.0 + z, 1});
        EXPECT_EQ(cellsOf(made()), start);
    }
    EXPECT_EQ(cellsOf(shown()), moved(isTower, [](int x, int y, int z) {
                  return Place{x, y, z + 4};
              }));
    settings.choose(ToolKind::brush);  // another tool puts it down
    moveTo({5, 5});
    EXPECT_EQ(cellsOf(made()), moved(isTower, [](int x, int y, int z) {
                  return Place{x, y, z + 4};
              }));
}

TEST_F(Selecting, TurnedFlippedAndScaledInTheAir) {
    // Of the tower, whose box is 5 x 6 x 5 at (-2, -2, 0), a part that no turn and no flip leaves
    // as it is.
    const auto part = [](int x, int y, int z) {
        return isTower(x, y, z) && (x < 0 || z < 2 || (y > 2 && z < 4));
    };
    selectOnly(part);
    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& f) { f.flip(1); });
    expectFloats(moved(part, [](int x, int y, int z) { return Place{x, 1 - y, z}; }));

    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& f) {
        for (int axis = 0; axis < 3; ++axis) f.turn(axis, 1);
        for (int axis = 2; axis >= 0; --axis) f.turn(axis, 3);
    });
    const Floating turned = *session.selection().floating();
    EXPECT_EQ(turned.clip.modelFromClip.rotation, SignedPermutation{});
    tools.cancel(session);

    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& f) { f.turn(2, 1); });
    const IBox box = session.selection().floating()->bounds();
    EXPECT_EQ(box.size(), glm::ivec3(6, 5, 5));
    // Counter-clockwise from above: what lay at the lowest y lies at the highest x.
    expectFloats(moved(part, [&](int x, int y, int z) {
        return Place{box.min.x + (3 - y), box.min.y + (x + 2), z};
    }));

    ASSERT_TRUE(lift(session, settings, Floating::Kind::move));
    session.selection().changeFloating([](Floating& f) { f.amount = 3; });
    Cells scaled = start;
    for (const auto& [at, value] : those(part)) scaled.erase(at);
    for (int x = 0; x < 15; ++x) {
        for (int y = 0; y < 18; ++y) {
            for (int z = 0; z < 15; ++z) {
                if (part(x / 3 - 2, y / 3 - 2, z / 3)) scaled[{x - 2, y - 2, z}] = 7;
            }
        }
    }
    expectFloats(scaled);
}

TEST_F(Selecting, CopiesGoToOtherObjectsAndOtherDocuments) {
    selectOnly(isTower);
    ASSERT_TRUE(copySelection(session));
    ASSERT_TRUE(session.perform(addObject(session.document(), "Other")));
    const auto other = static_cast<int>(session.document().nodes.size()) - 1;
    session.setActiveNode(other);
    ASSERT_TRUE(session.perform(turnNode(session.document(), other, 0, 1, 1)));
    ASSERT_TRUE(pasteClip(session));
    session.selection().changeFloating([](Floating& f) { f.moveBy({0, 0, 9}); });
    auto laid = putDown(session);
    ASSERT_TRUE(laid && *laid);
    ASSERT_TRUE(session.perform(std::move(**laid)));
    Cells after = start;
    for (const auto& [at, value] : those(isTower)) {
        const auto [x, y, z] = at;
        after[{x, y, z + 9}] = 7;
    }
    EXPECT_EQ(cellsOf(made()), after);  // as it looked on screen, whichever way the object lies
    EXPECT_EQ(session.document().models.at(1).voxels.solidCount(), those(isTower).size());

    ASSERT_TRUE(session.startNew());
    EXPECT_TRUE(session.selection().empty());
    ASSERT_TRUE(pasteClip(session));
    laid = putDown(session);
    ASSERT_TRUE(laid && *laid);
    ASSERT_TRUE(session.perform(std::move(**laid)));
    Cells alone;
    for (const auto& [at, value] : those(isTower)) alone[at] = 7;
    EXPECT_EQ(cellsOf(made()), alone);
}

TEST_F(Selecting, ADuplicateLiesBesideIt) {
    selectOnly(isTower);
    ASSERT_TRUE(duplicateSelection(session));
    Cells after = start;
    for (const auto& [at, value] : those(isTower)) {
        const auto [x, y, z] = at;
        after[{x + 5, y, z}] = 7;
    }
    expectFloats(after);
}

TEST_F(Selecting, DeletedRecolouredCroppedAndTrimmed) {
    selectOnly(isTower);
    Cells without = start, painted = start, alone;
    for (const auto& [at, value] : those(isTower)) {
        without.erase(at);
        painted[at] = 9;
        alone[at] = 7;
    }
    expectMade(deleteSelection(session, "Delete"), without);
    EXPECT_EQ(selected(), those(isTower));  // undone, it is selected again
    expectMade(recolourSelection(session, 9), painted);
    expectMade(cropToSelection(session), alone);
    expectMade(selectionToObject(session), start);
    session.selection().clear();
    Cells trimmed;
    for (const auto& [at, value] : start) {
        const auto [x, y, z] = at;
        if (x >= -3 && y < 2 && z >= -2) trimmed[at] = value;
    }
    expectMade(trimToBox(session, {{-3, -50, -2}, {50, 2, 50}}), trimmed);
}

TEST_F(Selecting, ToAnObjectOfItsOwn) {
    selectOnly(isTower);
    auto action = selectionToObject(session);
    ASSERT_TRUE(action);
    ASSERT_TRUE(session.perform(std::move(*action)));
    ASSERT_EQ(session.document().models.size(), 2u);
    EXPECT_EQ(session.document().models[1].voxels.solidCount(), those(isTower).size());
    EXPECT_EQ(session.document().models[0].voxels.solidCount(),
              start.size() - those(isTower).size());
    EXPECT_EQ(cellsOf(made()), start);
}

// One layer of the selection's own skin: what has a neighbour that is not selected.
TEST_F(Selecting, ReshapesTheSelectionAlone) {
    selectOnly(isTower);
    const Cells tower = those(isTower);
    const auto isSkin = [&](const Place& at) {
        const auto [x, y, z] = at;
        for (const int d : {-1, 1}) {
            if (!tower.contains({x + d, y, z}) || !tower.contains({x, y + d, z}) ||
                !tower.contains({x, y, z + d})) {
                return true;
            }
        }
        return false;
    };
    Cells hollow = start, core = start, grown = start;
    for (const auto& [at, value] : tower) {
        (isSkin(at) ? core : hollow).erase(at);
        const auto [x, y, z] = at;
        for (const int d : {-1, 1}) {
            // It fills the air, and leaves the block under it as it is.
            grown.insert({{x + d, y, z}, 7});
            grown.insert({{x, y + d, z}, 7});
            grown.insert({{x, y, z + d}, 7});
        }
    }
    ASSERT_TRUE(lift(session, settings, Floating::Kind::hollow));
    expectFloats(hollow);
    ASSERT_TRUE(lift(session, settings, Floating::Kind::erode));
    expectFloats(core);
    ASSERT_TRUE(lift(session, settings, Floating::Kind::dilate));
    expectFloats(grown);
    // The number is typed while the result is in sight, and the tool in hand comes back.
    settings.choose(ToolKind::brush);
    ASSERT_TRUE(lift(session, settings, Floating::Kind::erode));
    settings.choose(ToolKind::move);
    moveTo({1, 1});
    ASSERT_EQ(tools.tool()->figures().size(), 1u);
    tools.tool()->setFigure(0, 3);
    moveTo({2, 2});
    Cells gone = start;
    for (const auto& [at, value] : tower) gone.erase(at);
    EXPECT_EQ(cellsOf(shown()), gone);
    tools.cancel(session);
    moveTo({3, 3});
    EXPECT_EQ(cellsOf(shown()), start);
    EXPECT_EQ(settings.tool, ToolKind::brush);
}

TEST_F(Selecting, EditsGoEverywhereUnlessTheArtistWantsOtherwise) {
    selectOnly(isTower);
    settings.choose(ToolKind::brush);
    settings.mode = EditMode::paint;
    settings.options.tipEdge = 5;
    settings.options.tip = TipShape::sphere;
    const auto painted = [&](bool inside) {
        Cells cells = start;
        for (auto& [at, value] : cells) {
            const auto [x, y, z] = at;
            const int dx = x + 2, dy = y - 1, dz = z - 4;
            if (4 * (dx * dx + dy * dy + dz * dz) <= 25 && (!inside || isTower(x, y, z))) value = 9;
        }
        return cells;
    };
    click(faceOf({-2, 1, 4}));
    EXPECT_EQ(cellsOf(made()), painted(false));
    ASSERT_TRUE(session.undo());
    selectOnly([](int x, int, int z) { return z >= 0 && x >= -1; });
    settings.options.insideSelection = true;
    moveTo({9, 9});
    click(faceOf({-2, 1, 4}));
    Cells limited = painted(true);
    for (auto& [at, value] : limited) {
        if (std::get<0>(at) < -1) value = start.at(at);
    }
    EXPECT_EQ(cellsOf(made()), limited);
    ASSERT_TRUE(session.undo());
    // Attaching goes on, and without a selection all is as ever.
    session.selection().clear();
    moveTo({9, 9});
    click(faceOf({-2, 1, 4}));
    EXPECT_EQ(cellsOf(made()), painted(false));
}

TEST_F(Selecting, LockedAndHiddenObjectsStayAsTheyAre) {
    selectOnly(isTower);
    ASSERT_TRUE(session.perform(setLocked(session.document(), session.activeNode(), true)));
    EXPECT_FALSE(lift(session, settings, Floating::Kind::move));
    EXPECT_FALSE(deleteSelection(session, "Delete"));
    settings.choose(ToolKind::wand);
    moveTo(faceOf({0, 0, 4}));
    press();
    EXPECT_NE(refusal, "");
}

// Models stay in the document; what nothing shows cannot be selected.
TEST_F(Selecting, GoesWithTheModelAndComesBackWithIt) {
    const int object = session.activeNode();
    ASSERT_TRUE(
        session.perform(test::must(addFrame(session.document(), object, 0, NewFrame::copy))));
    ASSERT_TRUE(session.setFrame(1));
    ASSERT_TRUE(selectEverything(session));
    const int model = session.selection().model();
    ASSERT_NE(model, 0);
    ASSERT_TRUE(session.perform(test::must(deleteFrame(session.document(), 1))));
    EXPECT_TRUE(session.selection().empty());
    EXPECT_TRUE(chosenVoxels(session));
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.selection().model(), model);
    EXPECT_FALSE(session.selection().empty());
    ASSERT_TRUE(session.redo());

    const int copy = static_cast<int>(session.document().nodes.size());
    ASSERT_TRUE(session.perform(duplicateNode(session.document(), object, Copy::linked)));
    session.setActiveNode(copy);
    ASSERT_TRUE(selectEverything(session));
    ASSERT_EQ(session.selection().node(), copy);
    ASSERT_TRUE(session.perform(makeSingleUser(session.document(), copy)));
    EXPECT_TRUE(session.selection().empty());
}

// Whatever is done with the document, what is selected is solid.
TEST_F(Selecting, FollowsEveryEdit) {
    test::Random random(17);
    for (int round = 0; round < 60; ++round) {
        const int low = random.between(-12, 4), high = random.between(low, 11);
        const IBox box{{low, -12, -12}, {high + 1, random.between(-11, 12), 5}};
        switch (random.between(0, 5)) {
            case 0:
                session.selection().select(session.activeNode(), 0,
                                           selectBox(session.document().models[0].voxels, box),
                                           SelectMode::add);
                break;
            case 1:
                static_cast<void>(session.undo());
                break;
            case 2:
                static_cast<void>(session.redo());
                break;
            default:
                static_cast<void>(session.perform(makeAction(
                    "edit",
                    patchBox(session.document(), 0, box,
                             random.between(0, 1) == 0 ? EditMode::erase : EditMode::paint, 3))));
        }
        session.selection().voxels().forEach([&](glm::ivec3 v) {
            ASSERT_NE(session.document().models[0].voxels.get(v), 0) << round;
        });
    }
}

}  // namespace
}  // namespace voxprite::editor
