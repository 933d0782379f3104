// Everything that is done with a selection, in the real window: the keys and menus that an artist
// uses, recorded as a script. The document that the script leaves is compared with one that the
// test computes voxel by voxel.
#include <functional>
#include <map>
#include <sstream>
#include <tuple>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;
using Place = std::tuple<int, int, int>;
using Cells = std::map<Place, std::uint8_t>;

constexpr glm::ivec3 kSize(13, 11, 8);

class SelectionInAWindow : public EditorWindow {
  protected:
    // A box of one colour with a smaller one of another colour on it, seen from above.
    void open() {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        VoxelGrid voxels = solidBox(kSize, 5);
        voxels.fill({{5, 4, 8}, {8, 6, 10}}, 7);
        voxels.set({5, 4, 9}, 0);
        ASSERT_TRUE(saveDocument(file("a.voxprite"), documentOf(voxels), GameProfile{}));
        const Result<LoadedDocument> loaded = loadDocument(file("a.voxprite"));
        ASSERT_TRUE(loaded);
        document = loaded->document;
        start = cellsOf(document);
        ASSERT_NO_FATAL_FAILURE(startEditor({file("a.voxprite").string()}));
        await("the model",
              [&](const Json& now) { return now.at("state").at("voxels") == start.size(); });
        const glm::ivec2 middle = centreOf("view.edit");
        moveTo(middle);
        key("7");
        key("z");  // the wand, on the upper box
        await("the view from above", [](const Json& now) {
            const Json& state = now.at("state");
            return state.contains("hovered") && state.at("hovered").at("voxel").at(2) == 9 &&
                   state.at("hovered").at("normal").at(2) == 1;
        });
        click(middle);
        awaitSelected(11);
    }
    static Cells cellsOf(const Document& from) {
        Cells cells;
        flatten(from, 0).forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            cells[{v.x, v.y, v.z}] = value;
        });
        return cells;
    }
    void awaitSelected(std::uint64_t count) {
        await(std::to_string(count) + " voxels to be selected",
              [&](const Json& now) { return now.at("state").at("selected") == count; });
    }
    void awaitFloating(bool floating) {
        await(floating ? "something to float" : "nothing to float",
              [&](const Json& now) { return now.at("state").at("making") == floating; });
    }
    // By the palette of commands, which knows every one of them.
    void command(const std::string& name) {
        key("ctrl+p");
        await("the command palette",
              [](const Json& now) { return now.at("state").at("dialog") == "palette"; });
        type(name);
        key("Return");
        await("the command palette to be gone",
              [](const Json& now) { return now.at("state").at("dialog") == ""; });
        // It has the keys until the frame after.
        for (const int x : {300, 301, 302}) {
            moveTo({x, 500});
            await("a frame",
                  [&](const Json& now) { return now.at("state").at("pointer").at(0) == x; });
        }
    }
    static bool isTop(const Place& at) { return std::get<2>(at) >= 8; }
    // The start with the upper box moved.
    [[nodiscard]] Cells moved(const std::function<Place(int, int, int)>& to) const {
        Cells after = withoutTop();
        for (const auto& [at, value] : start) {
            const auto [x, y, z] = at;
            if (isTop(at)) after[to(x, y, z)] = value;
        }
        return after;
    }
    [[nodiscard]] Cells withoutTop() const {
        Cells after = start;
        std::erase_if(after, [](const auto& cell) { return isTop(cell.first); });
        return after;
    }
    void expectSaved(const std::string& what, const Cells& expected) {
        key("ctrl+s");
        await(what + " to be saved", [](const Json& now) {
            const Json& state = now.at("state");
            return state.at("unsaved") == false && state.at("working") == false;
        });
        const Result<LoadedDocument> loaded = loadDocument(file("a.voxprite"));
        ASSERT_TRUE(loaded) << loaded.error().describe();
        EXPECT_EQ(cellsOf(loaded->document), expected) << what;
    }
    // One step was made; it is undone, and all is as it was: the selection, too.
    void expectMade(const std::string& what, const Cells& expected) {
        await(what, [](const Json& now) { return now.at("state").at("steps") == 1; });
        ASSERT_NO_FATAL_FAILURE(expectSaved(what, expected));
        key("ctrl+z");
        await("an undo", [](const Json& now) { return now.at("state").at("steps") == 0; });
        ASSERT_NO_FATAL_FAILURE(expectSaved("the start after " + what, start));
    }
    void expectPutDown(const std::string& what, const Cells& expected) {
        ASSERT_NO_FATAL_FAILURE(awaitFloating(true));
        key("Return");
        ASSERT_NO_FATAL_FAILURE(awaitFloating(false));
        ASSERT_NO_FATAL_FAILURE(expectMade(what, expected));
        ASSERT_NO_FATAL_FAILURE(awaitSelected(11));
    }

    Document document;
    Cells start;
};

TEST_F(SelectionInAWindow, IsMovedTurnedCopiedAndReshaped) {
    ASSERT_NO_FATAL_FAILURE(open());

    // --- moved by keys; Esc drops it, Enter puts it down
    key("Right");
    key("Right");
    ASSERT_NO_FATAL_FAILURE(awaitFloating(true));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitFloating(false));
    EXPECT_EQ(state().at("steps"), 0);
    key("Right");
    key("Right");
    key("Up");
    key("Next");  // down, into the box
    key("Next");
    ASSERT_NO_FATAL_FAILURE(expectPutDown("move", moved([](int x, int y, int z) {
                                              return Place{x + 2, y + 1, z - 2};
                                          })));

    // --- turned, flipped, scaled
    key("ctrl+r");
    ASSERT_NO_FATAL_FAILURE(expectPutDown("turn", moved([](int x, int y, int z) {
                                              // 3 x 2 becomes 2 x 3 about about the same middle
                                              return Place{5 + (5 - y), 4 + (x - 5), z};
                                          })));
    command("Flip voxels left and right");
    ASSERT_NO_FATAL_FAILURE(expectPutDown("flip", moved([](int x, int y, int z) {
                                              return Place{12 - x, y, z};
                                          })));
    command("Scale by a whole number");
    Cells scaled = withoutTop();
    for (const auto& [at, value] : start) {
        const auto [x, y, z] = at;
        for (int i = 0; isTop(at) && i < 8; ++i) {
            scaled[{5 + 2 * (x - 5) + (i & 1), 4 + 2 * (y - 4) + (i >> 1 & 1),
                    8 + 2 * (z - 8) + (i >> 2)}] = value;
        }
    }
    ASSERT_NO_FATAL_FAILURE(expectPutDown("scale", scaled));

    // --- the clipboard
    key("ctrl+c");
    key("ctrl+v");
    key("Prior");
    key("Prior");
    Cells pasted = start;
    for (const auto& [at, value] : start) {
        const auto [x, y, z] = at;
        if (isTop(at)) pasted[{x, y, z + 2}] = value;
    }
    ASSERT_NO_FATAL_FAILURE(expectPutDown("paste", pasted));
    key("ctrl+d");
    Cells duplicated = start;
    for (const auto& [at, value] : start) {
        const auto [x, y, z] = at;
        if (isTop(at)) duplicated[{x + 3, y, z}] = value;
    }
    ASSERT_NO_FATAL_FAILURE(expectPutDown("duplicate", duplicated));
    key("ctrl+x");
    ASSERT_NO_FATAL_FAILURE(expectMade("cut", withoutTop()));
    key("Delete");
    ASSERT_NO_FATAL_FAILURE(expectMade("delete", withoutTop()));

    // --- at once
    Cells painted = start, alone;
    const auto colour = static_cast<std::uint8_t>(state().at("colour").get<int>());
    for (const auto& [at, value] : start) {
        if (!isTop(at)) continue;
        painted[at] = colour;
        alone[at] = value;
    }
    command("Recolour to the colour in hand");
    ASSERT_NO_FATAL_FAILURE(expectMade("recolour", painted));
    command("Crop the object to the selection");
    ASSERT_NO_FATAL_FAILURE(expectMade("crop", alone));
    command("To a new object");
    ASSERT_NO_FATAL_FAILURE(expectMade("to an object", start));
    ASSERT_NO_FATAL_FAILURE(awaitSelected(11));

    // --- all, inverted, none; then the whole object is meant
    key("ctrl+a");
    ASSERT_NO_FATAL_FAILURE(awaitSelected(start.size()));
    key("ctrl+shift+a");
    ASSERT_NO_FATAL_FAILURE(awaitSelected(0));
    command("Hollow out");
    ASSERT_NO_FATAL_FAILURE(awaitFloating(true));
    const glm::ivec2 figure = centreOf("options.figure.0");
    moveTo(figure);
    click(figure);
    click(figure);
    key("ctrl+a");
    type("2");
    key("Return");
    await("a wall of two", [](const Json& now) { return now.at("state").at("amount") == 2; });
    key("Return");
    Cells hollow;
    for (const auto& [at, value] : start) {
        // What is left has an empty voxel within two steps through faces.
        const auto [x, y, z] = at;
        bool outside = false;
        for (int i = -2; i <= 2; ++i) {
            for (int j = -2; j <= 2; ++j) {
                for (int k = -2; k <= 2; ++k) {
                    if (std::abs(i) + std::abs(j) + std::abs(k) > 2) continue;
                    outside = outside || !start.contains({x + i, y + j, z + k});
                }
            }
        }
        if (outside) hollow[at] = value;
    }
    EXPECT_LT(hollow.size(), start.size());
    ASSERT_NO_FATAL_FAILURE(expectMade("hollow out", hollow));
    command("Centre on the origin");
    Cells centred;
    for (const auto& [at, value] : start) {
        const auto [x, y, z] = at;
        centred[{x - 6, y - 5, z}] = value;
    }
    ASSERT_NO_FATAL_FAILURE(expectMade("centre", centred));

    const Result<LoadedDocument> end = loadDocument(file("a.voxprite"));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->document, document);
}

}  // namespace
}  // namespace voxprite::test
