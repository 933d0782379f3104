// The window around the views: the first start, finding commands, keys bound anew, panels that
// fold, cameras; and that all of it is still there at the next start.
#include <fstream>
#include <map>

#include "core/io/formats.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class EditorInterface : public EditorWindow {
  protected:
    void startWithBox() {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        ASSERT_TRUE(
            saveDocument(file("box.vox"), documentOf(solidBox({12, 10, 8}, 5)), GameProfile{}));
        ASSERT_NO_FATAL_FAILURE(startEditor({file("box.vox").string()}));
        ASSERT_NO_FATAL_FAILURE(awaitState("voxels", 960));
    }
    void startAgain() {
        key("ctrl+q");
        ASSERT_EQ(editor().wait(), 0) << said();
        std::filesystem::remove(file("layout.json"));
        ASSERT_NO_FATAL_FAILURE(startEditor({file("box.vox").string()}));
        ASSERT_NO_FATAL_FAILURE(awaitState("voxels", 960));
    }
    void awaitState(const std::string& name, const Json& value) {
        await(name + " = " + value.dump(),
              [&](const Json& now) { return now.at("state").at(name) == value; });
    }
    void awaitCamera(const std::string& name, const Json& value) {
        await("camera " + name + " = " + value.dump(),
              [&](const Json& now) { return now.at("state").at("camera").at(name) == value; });
    }
    // Of what the editor says now; a drag loses what is moved in the frame of its release.
    [[nodiscard]] static double yawOf(const Json& now) {
        return now.at("state").at("camera").at("yaw").get<double>();
    }
    [[nodiscard]] static float widthOf(const Json& now, const std::string& item) {
        const Json& box = now.at("items").at(item);
        return box.at(2).get<float>() - box.at(0).get<float>();
    }
    // The layout file may be in the middle of being written.
    [[nodiscard]] Json whole() {
        Json all;
        await("a whole layout", [&](const Json& now) {
            all = now;
            return true;
        });
        return all;
    }
};

TEST_F(EditorInterface, TheFirstStartExplainsTheWindowOnce) {
    showTour();
    ASSERT_NO_FATAL_FAILURE(startWithBox());
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", "tour"));
    // Nothing is drawn while it is up.
    click(centreOf("view.edit"));
    EXPECT_EQ(whole().at("state").at("steps"), 0);
    click(centreOf("tour.start"));
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", ""));
    ASSERT_NO_FATAL_FAILURE(startAgain());
    EXPECT_EQ(whole().at("state").at("dialog"), "");

    // Again from the command palette, which finds it by a few letters.
    key("ctrl+p");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", "palette"));
    static_cast<void>(centreOf("palette.query"));
    type("tour");
    static_cast<void>(centreOf("palette.tour"));
    key("Return");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", "tour"));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", ""));
}

TEST_F(EditorInterface, KeysPanelsAndViewsStayAsTheyWereSet) {
    ASSERT_NO_FATAL_FAILURE(startWithBox());
    const float viewWidth = widthOf(whole(), "view.edit");
    const float sideWidth = widthOf(whole(), "panel.inspector");

    // F9 undoes, besides nothing else.
    key("F1");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", "preferences"));
    click(centreOf("preferences.search"));
    type("undo");
    click(centreOf("preferences.key.undo"));
    key("F9");
    click(centreOf("preferences.done"));
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", ""));

    // A wider side panel, and a view under a name.
    const glm::ivec2 bar = centreOf("panel.sideBar");
    drag(bar, {bar.x - 60, bar.y});
    await("wider side panels",
          [&](const Json& now) { return widthOf(now, "panel.inspector") >= sideWidth + 40; });
    key("3");
    ASSERT_NO_FATAL_FAILURE(awaitCamera("yaw", 90.0));
    key("5");
    ASSERT_NO_FATAL_FAILURE(awaitCamera("orthographic", true));
    key("v");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", "cameras"));
    click(centreOf("cameras.name"));
    type("Side");
    click(centreOf("cameras.keep"));
    static_cast<void>(centreOf("cameras.Side"));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitState("dialog", ""));

    // Nothing but the views, and back.
    key("Tab");
    await("wide views", [&](const Json& now) {
        return widthOf(now, "view.edit") > viewWidth + 100 &&
               !now.at("items").contains("panel.tools");
    });
    key("Tab");
    await("the panels again",
          [](const Json& now) { return now.at("items").contains("panel.tools"); });

    ASSERT_NO_FATAL_FAILURE(startAgain());
    EXPECT_GE(widthOf(whole(), "panel.inspector"), sideWidth + 40);
    EXPECT_EQ(whole().at("state").at("camera").at("orthographic"), false);
    key("v");
    click(centreOf("cameras.Side"));
    ASSERT_NO_FATAL_FAILURE(awaitCamera("orthographic", true));
    EXPECT_EQ(yawOf(whole()), 90.0);
    click(centreOf("view.edit"));
    ASSERT_NO_FATAL_FAILURE(awaitState("voxels", 961));
    key("F9");
    ASSERT_NO_FATAL_FAILURE(awaitState("voxels", 960));
}

// Whatever is being made, and however little room there is, nothing in the bar lies over anything
// else in it or is cut.
TEST_F(EditorInterface, OptionsLieBesideEachOther) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
    ASSERT_TRUE(saveDocument(file("box.vox"), documentOf(solidBox({12, 10, 8}, 5)), GameProfile{}));
    std::filesystem::create_directories(file("config") / "voxprite");
    struct Room {
        const char* window;
        bool all;
    };
    for (const Room& room :
         {Room{R"("side_width": 320)", true}, Room{R"("side_width": 520)", false},
          Room{R"("scale": 1.75)", false}}) {
        SCOPED_TRACE(room.window);
        std::ofstream(file("config") / "voxprite" / "editor.json")
            << R"({"window": {"tour_seen": true, )" << room.window << "}}";
        ASSERT_NO_FATAL_FAILURE(startEditor({file("box.vox").string()}));
        ASSERT_NO_FATAL_FAILURE(awaitState("voxels", 960));
        key("n");  // a line, and its figures
        const glm::ivec2 from = centreOf("view.edit");
        drag(from, from + glm::ivec2(24, 16));
        ASSERT_NO_FATAL_FAILURE(awaitState("making", true));
        static_cast<void>(centreOf("options.keep"));
        const Json items = whole().at("items");
        EXPECT_TRUE(items.contains("options.figure.2"));
        EXPECT_EQ(items.contains("options.more"), !room.all);
        using Box = std::vector<double>;
        const Box bar = items.at("panel.options").get<Box>();
        std::map<std::string, Box> options;
        for (const auto& [item, box] : items.items()) {
            if (item.starts_with("options.")) options[item] = box.get<Box>();
        }
        for (const auto& [a, first] : options) {
            EXPECT_TRUE(first[0] >= bar[0] && first[1] >= bar[1] && first[2] <= bar[2] &&
                        first[3] <= bar[3])
                << a;
            for (const auto& [b, second] : options) {
                if (a >= b) continue;
                EXPECT_TRUE(first[2] <= second[0] || second[2] <= first[0]) << a << " and " << b;
            }
        }
        editor().kill();
    }
}

TEST_F(EditorInterface, TheCubeAndTheHabitsOfAnotherProgramTurnTheView) {
    std::filesystem::create_directories(file("config") / "voxprite");
    std::ofstream(file("config") / "voxprite" / "editor.json")
        << R"({"window": {"tour_seen": true}, "input": {"navigation": 1}})";
    ASSERT_NO_FATAL_FAILURE(startWithBox());
    const glm::ivec2 middle = centreOf("view.edit"), cube = centreOf("view.cube");
    const double start = yawOf(whole());
    // Blender: the right button is nobody's, the middle one orbits.
    drag(middle, {middle.x + 50, middle.y}, 3);
    drag(middle, {middle.x + 60, middle.y}, 2);
    await("an orbit of 60 pixels, not of 110",
          [&](const Json& now) { return yawOf(now) < start - 15.0 && yawOf(now) > start - 25.0; });

    // From the front the cube's middle is its front; a drag on it orbits and draws nothing.
    key("1");
    ASSERT_NO_FATAL_FAILURE(awaitCamera("yaw", 0.0));
    drag(cube, {cube.x - 100, cube.y});
    await("an orbit by the cube",
          [](const Json& now) { return yawOf(now) > 25.0 && yawOf(now) < 41.0; });
    // Left of its middle there is then the front again, which a click looks from.
    click({cube.x - 14, cube.y});
    ASSERT_NO_FATAL_FAILURE(awaitCamera("yaw", 0.0));
    const Json now = whole().at("state");
    EXPECT_EQ(now.at("camera").at("pitch"), 0.0);
    EXPECT_EQ(now.at("steps"), 0);
}

}  // namespace
}  // namespace voxprite::test
