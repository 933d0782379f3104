// A window comes back to where it was, or to where it can be.
#include "app/editor/window/window_place.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/editor/settings/settings_json.h"
#include "tests/app/editor_window.h"

namespace voxprite::editor {
namespace {

constexpr std::array kTwo{WorkArea{{0, 24}, {1920, 1056}}, WorkArea{{1920, 0}, {1280, 1024}}};

WindowPlace at(int x, int y, int width, int height) {
    return {.x = x, .y = y, .width = width, .height = height, .known = true};
}

TEST(WindowPlace, ComesBack) {
    EXPECT_EQ(placeOn(kTwo, at(200, 100, 900, 700), 1.0), at(200, 100, 900, 700));
    EXPECT_EQ(placeOn(kTwo, at(2000, 50, 1000, 800), 1.0), at(2000, 50, 1000, 800));
    EXPECT_EQ(placeOn({}, at(5, 6, 700, 500), 2.0), at(5, 6, 1400, 1000));
}

TEST(WindowPlace, LiesWhollyOnOneDisplay) {
    // Mostly on the first.
    EXPECT_EQ(placeOn(kTwo, at(1300, 500, 1000, 800), 1.0), at(920, 280, 1000, 800));
    // Its title bar must be within reach.
    EXPECT_EQ(placeOn(kTwo, at(-500, -300, 1000, 800), 1.0), at(0, 24, 1000, 800));
    EXPECT_EQ(placeOn(kTwo, at(2100, 100, 5000, 4000), 1.0), at(1920, 0, 1280, 1024));
    EXPECT_EQ(placeOn(kTwo, at(100, 100, 800, 500), 2.0), at(100, 80, 1600, 1000));
}

TEST(WindowPlace, IsForgottenWithItsDisplay) {
    const std::array one{kTwo[0]};
    const WindowPlace gone = placeOn(one, at(2000, 50, 1000, 800), 1.0);
    EXPECT_FALSE(gone.known);
    EXPECT_EQ(gone.width, 1000);
    EXPECT_EQ(gone.height, 800);
}

TEST(WindowPlace, IsKeptInTheSettings) {
    EditorSettings settings;
    settings.window.place = at(-300, 40, 1000, 700);
    settings.window.place.maximized = true;
    EXPECT_EQ(settingsFrom(jsonOf(settings)).window.place, settings.window.place);
    EXPECT_EQ(settingsFrom(nlohmann::json::object()).window.place, WindowPlace{});
}

class WindowComesBack : public test::EditorWindow {
  protected:
    // Where the X server has the editor's window: "Position: 120,60 ... Geometry: 900x700".
    [[nodiscard]] std::string whereItIs() const {
        const std::string command = "DISPLAY=" + display() +
                                    " xdotool search --onlyvisible --name voxprite "
                                    "getwindowgeometry 2>/dev/null";
        std::string text;
        if (FILE* pipe = popen(command.c_str(), "r"); pipe != nullptr) {
            for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
                text += static_cast<char>(c);
            }
            pclose(pipe);
        }
        return text;
    }
};

TEST_F(WindowComesBack, ToWhereItWasAndIsRememberedThere) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1400, 900}));
    const std::filesystem::path settings = file("config") / "voxprite" / "editor.json";
    std::filesystem::create_directories(settings.parent_path());
    nlohmann::json kept{
        {"window", {{"tour_seen", true}}},
        {"place", {{"x", 120}, {"y", 60}, {"width", 900}, {"height", 700}, {"known", true}}}};
    std::ofstream(settings) << kept;
    ASSERT_NO_FATAL_FAILURE(startEditor({}));
    const std::string where = whereItIs();
    EXPECT_NE(where.find("Position: 120,60"), std::string::npos) << where;
    EXPECT_NE(where.find("Geometry: 900x700"), std::string::npos) << where;
    key("ctrl+q");
    EXPECT_EQ(editor().wait(), 0) << said();

    // A window larger than the display, on one that is gone.
    kept["place"] = {{"x", 5000}, {"y", 60}, {"width", 4000}, {"height", 3000}, {"known", true}};
    std::ofstream(settings) << kept;
    ASSERT_NO_FATAL_FAILURE(startEditor({}));
    EXPECT_NE(whereItIs().find("Geometry: 1400x900"), std::string::npos) << whereItIs();
    key("ctrl+q");
    EXPECT_EQ(editor().wait(), 0) << said();
    nlohmann::json after;
    std::ifstream(settings) >> after;
    EXPECT_EQ(after.at("place").at("width"), 1400);
    EXPECT_EQ(after.at("place").at("height"), 900);
    EXPECT_TRUE(after.at("place").at("known"));
}

}  // namespace
}  // namespace voxprite::editor
