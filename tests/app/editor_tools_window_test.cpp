// Every tool in the real window, by mouse and keyboard. After each step the document is saved and
// read back, and is what the test computed by itself from the voxels under the pointer. At the end
// everything is undone, and the document is the one that was opened.
#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

constexpr glm::ivec3 kSize(13, 11, 8);
constexpr int kTop = 7;  // the layer that is seen

glm::ivec3 vectorOf(const Json& json) {
    return {json.at(0).get<int>(), json.at(1).get<int>(), json.at(2).get<int>()};
}

class ToolsInAWindow : public EditorWindow {
  protected:
    // A solid box of one colour, seen from above.
    void open() {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        document = documentOf(solidBox(kSize, 5));
        expected = flatten(document, 0);
        ASSERT_TRUE(saveDocument(file("a.voxprite"), document, GameProfile{}));
        const Result<LoadedDocument> loaded = loadDocument(file("a.voxprite"));
        ASSERT_TRUE(loaded);
        document = loaded->document;
        expectedAnchor = document.entity.anchorVoxels;
        ASSERT_NO_FATAL_FAILURE(startEditor({file("a.voxprite").string()}));
        await("the box",
              [](const Json& now) { return now.at("state").at("voxels") == 13 * 11 * 8; });
        middle = centreOf("view.edit");
        pointTo(middle);
        key("7");
        await("the view from above", [](const Json& now) {
            const Json& state = now.at("state");
            return state.contains("hovered") &&
                   vectorOf(state.at("hovered").at("normal")) == glm::ivec3(0, 0, 1) &&
                   vectorOf(state.at("hovered").at("voxel")) == glm::ivec3(6, 5, kTop);
        });
        colour = static_cast<std::uint8_t>(state().at("colour").get<int>());
        ASSERT_NE(colour, 5);
    }
    void pointTo(glm::ivec2 px) {
        moveTo(px);
        await("the pointer at its place", [&](const Json& now) {
            const Json& at = now.at("state").at("pointer");
            return at.at(0) == px.x && at.at(1) == px.y;
        });
    }
    // Where a voxel of column (x, y) is seen from above; found by looking, and by going there.
    void find(int x, int y, glm::ivec2& px) {
        const auto known = places.find({x, y});
        px = known != places.end() ? known->second : middle;
        for (int look = 0; look < 40; ++look) {
            pointTo(px);
            const Json now = state();
            ASSERT_TRUE(now.contains("hovered"));
            const glm::ivec3 at = vectorOf(now.at("hovered").at("voxel"));
            if (at.x == x && at.y == y) {
                places[{x, y}] = px;
                return;
            }
            px += glm::ivec2((x - at.x) * 20, (at.y - y) * 20);
        }
        FAIL() << "voxel " << x << ", " << y << " is not to be found";
    }
    void clickVoxel(int x, int y) {
        glm::ivec2 px(0);
        ASSERT_NO_FATAL_FAILURE(find(x, y, px));
        click(px);
    }
    void dragVoxels(glm::ivec2 from, glm::ivec2 to) {
        glm::ivec2 a(0), b(0);
        ASSERT_NO_FATAL_FAILURE(find(to.x, to.y, b));
        ASSERT_NO_FATAL_FAILURE(find(from.x, from.y, a));
        drag(a, b);
        await("the button to be up and a shape to be there",
              [](const Json& now) { return now.at("state").at("making").get<bool>(); });
    }
    void typeFigure(int index, const std::string& text) {
        const glm::ivec2 field = centreOf("options.figure." + std::to_string(index));
        pointTo(field);
        keyDown("ctrl");
        click(field);
        keyUp("ctrl");
        key("ctrl+a");
        type(text);
        key("Return");
    }
    template <class Holds>
    void put(std::uint8_t value, const Holds& holds) {
        for (int x = -20; x < 40; ++x) {
            for (int y = -20; y < 40; ++y) {
                for (int z = -20; z < 40; ++z) {
                    if (holds(x, y, z)) expected.set({x, y, z}, value);
                }
            }
        }
    }
    // The step that was just made: saved and read back.
    void expectMade(const std::string& what) {
        ++steps;
        await(what, [&](const Json& now) { return now.at("state").at("steps") == steps; });
        ASSERT_NO_FATAL_FAILURE(expectSaved(what));
    }
    void expectSaved(const std::string& what) {
        key("ctrl+s");
        await(what + " to be saved",
              [](const Json& now) { return now.at("state").at("unsaved") == false; });
        // Files are written in the background.
        VoxelGrid found;
        std::optional<glm::dvec3> anchor;
        for (int look = 0; look < 400; ++look) {
            const Result<LoadedDocument> loaded = loadDocument(file("a.voxprite"));
            ASSERT_TRUE(loaded) << loaded.error().describe();
            found = flatten(loaded->document, 0);
            anchor = loaded->document.entity.anchorVoxels;
            if (found == expected && anchor == expectedAnchor) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        EXPECT_EQ(found, expected) << what;
        EXPECT_EQ(anchor, expectedAnchor) << what;
    }
    void undoStep() {
        key("ctrl+z");
        --steps;
        await("an undo", [&](const Json& now) { return now.at("state").at("steps") == steps; });
    }

    Document document;
    VoxelGrid expected;
    std::optional<glm::dvec3> expectedAnchor;
    glm::ivec2 middle{0};
    std::map<std::pair<int, int>, glm::ivec2> places;  // where columns were found
    std::uint8_t colour = 0;
    int steps = 0;
};

TEST_F(ToolsInAWindow, EveryToolDoesWhatWasComputedAndIsUndone) {
    ASSERT_NO_FATAL_FAILURE(open());
    const VoxelGrid start = expected;

    // --- brush: attach, erase, paint; Shift; tips
    clickVoxel(3, 4);
    expected.set({3, 4, kTop + 1}, colour);
    ASSERT_NO_FATAL_FAILURE(expectMade("attach"));
    key("r");
    clickVoxel(9, 8);
    expected.set({9, 8, kTop}, 0);
    ASSERT_NO_FATAL_FAILURE(expectMade("erase"));
    key("g");
    clickVoxel(8, 2);
    expected.set({8, 2, kTop}, colour);
    ASSERT_NO_FATAL_FAILURE(expectMade("paint"));
    key("t");
    glm::ivec2 px(0);
    ASSERT_NO_FATAL_FAILURE(find(4, 7, px));
    keyDown("shift");
    click(px);
    keyUp("shift");
    expected.set({4, 7, kTop}, 0);
    ASSERT_NO_FATAL_FAILURE(expectMade("attach with Shift"));
    key("g");
    for (int i = 0; i < 4; ++i) key("equal");
    click(centreOf("options.tip.1"));
    clickVoxel(6, 3);  // a sphere of 5
    put(colour, [&](int x, int y, int z) {
        const int dx = x - 6, dy = y - 3, dz = z - kTop;
        return 4 * (dx * dx + dy * dy + dz * dz) <= 25 && expected.get({x, y, z}) != 0;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("paint a sphere"));
    for (int i = 0; i < 4; ++i) key("minus");
    while (steps > 0) undoStep();
    expected = start;
    ASSERT_NO_FATAL_FAILURE(expectSaved("the start"));

    // --- stamp: the whole block on top of itself
    key("t");
    key("ctrl+a");
    key("ctrl+c");
    key("x");
    clickVoxel(6, 5);
    put(5, [](int x, int y, int z) {
        return x >= 0 && x < 13 && y >= 0 && y < 11 && z > kTop && z <= kTop + 8;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("stamp"));
    undoStep();
    expected = start;

    // --- shapes
    key("u");
    dragVoxels({2, 3}, {5, 7});
    typeFigure(2, "3");
    key("Return");
    put(colour, [](int x, int y, int z) {
        return x >= 2 && x <= 5 && y >= 3 && y <= 7 && z > kTop && z <= kTop + 3;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("box"));
    undoStep();
    expected = start;
    click(centreOf("options.hollow.1"));
    dragVoxels({2, 3}, {6, 7});
    typeFigure(2, "4");
    key("Return");
    put(colour, [](int x, int y, int z) {
        const bool in = x >= 2 && x <= 6 && y >= 3 && y <= 7 && z > kTop && z <= kTop + 4;
        return in && (x == 2 || x == 6 || y == 3 || y == 7 || z == kTop + 1 || z == kTop + 4);
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("hollow box"));
    undoStep();
    expected = start;
    click(centreOf("options.hollow.0"));
    key("h");
    dragVoxels({4, 2}, {8, 5});
    key("Return");
    put(colour, [](int x, int y, int z) {
        const int dx = x - 6, dy = y - 4, dz = z - (kTop + 3);
        return 4 * (dx * dx + dy * dy + dz * dz) <= 25;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("sphere"));
    undoStep();
    expected = start;
    key("j");
    dragVoxels({2, 3}, {8, 7});
    key("Return");
    put(colour, [](int x, int y, int z) {
        const double fx = 2.0 * (x - 5) / 7, fy = 2.0 * (y - 5) / 5, fz = 2.0 * (z - kTop - 3) / 5;
        return fx * fx + fy * fy + fz * fz <= 1.0 + 1e-12;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("ellipsoid"));
    undoStep();
    expected = start;
    key("y");
    dragVoxels({3, 2}, {7, 6});
    typeFigure(2, "5");
    key("Return");
    put(colour, [](int x, int y, int z) {
        const int dx = x - 5, dy = y - 4;
        return 4 * (dx * dx + dy * dy) <= 25 && z > kTop && z <= kTop + 5;
    });
    ASSERT_NO_FATAL_FAILURE(expectMade("cylinder"));
    undoStep();
    expected = start;
    key("n");
    dragVoxels({2, 6}, {10, 6});
    key("Return");
    put(colour, [](int x, int y, int z) { return x >= 2 && x <= 10 && y == 6 && z == kTop + 1; });
    ASSERT_NO_FATAL_FAILURE(expectMade("line"));

    // --- fill the line, then a face of its own colour
    key("i");
    clickVoxel(0, 0);
    await("the picked colour", [](const Json& now) { return now.at("state").at("colour") == 5; });
    key("k");
    clickVoxel(5, 6);
    put(5, [](int x, int y, int z) { return x >= 2 && x <= 10 && y == 6 && z == kTop + 1; });
    ASSERT_NO_FATAL_FAILURE(expectMade("fill"));
    undoStep();
    undoStep();
    expected = start;
    key("f");
    clickVoxel(6, 5);
    await("a face", [](const Json& now) { return now.at("state").at("making").get<bool>(); });
    typeFigure(0, "-2");
    key("Return");
    put(0, [](int, int, int z) { return z == kTop || z == kTop - 1; });
    ASSERT_NO_FATAL_FAILURE(expectMade("push a face"));
    undoStep();
    expected = start;

    // --- a pit, and the plane fill that closes it
    key("r");
    key("u");
    dragVoxels({4, 3}, {8, 6});
    key("Return");
    put(0, [](int x, int y, int z) { return x >= 4 && x <= 8 && y >= 3 && y <= 6 && z == kTop; });
    ASSERT_NO_FATAL_FAILURE(expectMade("pit"));
    key("t");
    key("p");
    clickVoxel(6, 5);
    put(5, [](int x, int y, int z) { return x >= 4 && x <= 8 && y >= 3 && y <= 6 && z == kTop; });
    ASSERT_NO_FATAL_FAILURE(expectMade("plane fill"));

    // --- the laser, straight down through the middle of the view
    key("l");
    pointTo(middle + glm::ivec2(1, 1));
    pointTo(middle);
    click(middle);
    put(0, [](int x, int y, int z) { return x == 6 && y == 5 && z >= 0 && z <= kTop; });
    ASSERT_NO_FATAL_FAILURE(expectMade("laser"));

    // --- mirrors and limits
    key("b");
    click(centreOf("options.mirror.x"));
    click(centreOf("options.mirror.y"));
    clickVoxel(2, 2);
    for (const int x : {2, 10}) {
        for (const int y : {2, 8}) expected.set({x, y, kTop + 1}, 5);
    }
    ASSERT_NO_FATAL_FAILURE(expectMade("mirrored"));
    click(centreOf("options.limit"));  // around the model, which is one layer higher now
    clickVoxel(2, 2);
    clickVoxel(4, 4);
    for (const int x : {4, 8}) {
        for (const int y : {4, 6}) expected.set({x, y, kTop + 1}, 5);
    }
    ASSERT_NO_FATAL_FAILURE(expectMade("limited"));

    // --- the anchor, which is no voxel
    key("a");
    clickVoxel(3, 3);
    expectedAnchor = {3.5, 3.5, kTop + 0.5};
    ASSERT_NO_FATAL_FAILURE(expectMade("anchor"));

    while (steps > 0) undoStep();
    expected = start;
    expectedAnchor = document.entity.anchorVoxels;
    ASSERT_NO_FATAL_FAILURE(expectSaved("the end"));
    key("ctrl+q");  // nothing is unsaved, so that it ends at once, when the file is whole
    ASSERT_EQ(editor().wait(), 0) << said();
    const Result<LoadedDocument> end = loadDocument(file("a.voxprite"));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->document, document);
}

}  // namespace
}  // namespace voxprite::test
