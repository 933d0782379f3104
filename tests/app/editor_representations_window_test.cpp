// By what the scene is drawn, and all of it side by side, by mouse and keyboard.
#include "core/io/png.h"
#include "tests/app/editor_window.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class RepresentationsWindow : public EditorWindow {
  protected:
    // By the palette of commands.
    void ask(const std::string& command) {
        key("ctrl+p");
        await("the command palette",
              [](const Json& now) { return now.at("state").at("dialog") == "palette"; });
        type(command);
        key("Return");
        await("the command palette to be gone",
              [](const Json& now) { return now.at("state").at("dialog") == ""; });
        // It has the keys until the frame after.
        for (const int x : {300, 301, 302}) settleAt({x, 500});
    }
    void awaitDrawnBy(std::size_t kind, int count) {
        await("drawn by " + std::to_string(kind), [&](const Json& now) {
            return now.at("state").at("sprites").at("drawn_by").at(kind) == count;
        });
    }
};

TEST_F(RepresentationsWindow, TheSceneIsDrawnByWhatIsAskedFor) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    click(centreOf("dock.Scene"));
    click(centreOf("scene.pattern.1"));
    click(centreOf("scene.camera.frame_scene"));
    ASSERT_NO_FATAL_FAILURE(awaitDrawnBy(0, 101));
    ASSERT_NO_FATAL_FAILURE(ask("draw snapshots"));
    ASSERT_NO_FATAL_FAILURE(awaitDrawnBy(1, 101));
    ASSERT_NO_FATAL_FAILURE(ask("draw clusters"));
    ASSERT_NO_FATAL_FAILURE(awaitDrawnBy(2, 101));
    ASSERT_NO_FATAL_FAILURE(ask("draw coarser octrees"));
    ASSERT_NO_FATAL_FAILURE(awaitDrawnBy(3, 101));
    ASSERT_NO_FATAL_FAILURE(ask("tint entities"));
    ASSERT_NO_FATAL_FAILURE(ask("draw exact sprites"));
    ASSERT_NO_FATAL_FAILURE(awaitDrawnBy(0, 101));
    // Nothing of it is an edit.
    EXPECT_EQ(state().at("steps"), 0);
    EXPECT_EQ(state().at("unsaved"), false);
}

TEST_F(RepresentationsWindow, AllStandSideBySideFromAnyDistance) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    ASSERT_NO_FATAL_FAILURE(ask("compare representations"));
    static_cast<void>(centreOf("represent.3"));
    EXPECT_EQ(state().at("representations").at("compared"), true);
    const Json items = layout().at("items");
    const auto rect = [&](const std::string& name) {
        return items.at(name).get<std::array<double, 4>>();
    };
    const auto view = rect("view.sprite");
    for (int cell = 0; cell < 4; ++cell) {
        const auto inside = [](const auto& inner, const auto& outer) {
            return inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] &&
                   inner[3] <= outer[3];
        };
        const auto area = rect("represent." + std::to_string(cell));
        EXPECT_TRUE(inside(area, view)) << cell;
        EXPECT_TRUE(inside(rect("represent.caption." + std::to_string(cell)), area)) << cell;
    }
    const auto size = [this] { return state().at("representations").at("size_px").get<double>(); };
    const auto slider = rect("represent.distance");
    const int y = static_cast<int>((slider[1] + slider[3]) / 2);
    click({static_cast<int>(slider[2]) - 4, y});
    await("far", [&](const Json&) { return size() < 5.0; });
    click({static_cast<int>(slider[0]) + 4, y});
    await("near", [&](const Json&) { return size() > 100.0; });
    const double near = size();
    click(centreOf("command.fly_representations"));
    await("a flight", [&](const Json& now) {
        return now.at("state").at("representations").at("flying") == true && size() < 0.9 * near;
    });
    ASSERT_NO_FATAL_FAILURE(ask("compare representations"));
    await("the scene", [](const Json& now) {
        return now.at("state").at("representations").at("compared") == false;
    });
    EXPECT_EQ(state().at("steps"), 0);
}

}  // namespace
}  // namespace voxprite::test
