#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/editor/settings/settings.h"
#include "app/editor/window/input.h"
#include "app/editor/window/layout_probe.h"
#include "app/editor/window/play_script.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::editor {
namespace {

InputEvent moveTo(double x, double y) {
    InputEvent event;
    event.position = {x, y};
    return event;
}
InputEvent event(InputKind kind, int code, bool down) {
    InputEvent made;
    made.kind = kind;
    made.code = code;
    made.down = down;
    return made;
}

TEST(EditorInput, AFastClickSpansTwoFrames) {
    InputQueue queue;
    queue.push(moveTo(1, 1));
    queue.push(moveTo(2, 2));
    queue.push(event(InputKind::button, 0, true));
    queue.push(event(InputKind::button, 0, false));
    queue.push(moveTo(3, 3));
    EXPECT_EQ(queue.takeFrame().size(), 3u);  // both moves and the press
    EXPECT_EQ(queue.takeFrame().size(), 1u);  // the release
    EXPECT_EQ(queue.takeFrame().size(), 1u);
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(queue.takeFrame().empty());
}

// A split bar dragged by a fast hand, on a slow machine, lost what came last.
TEST(EditorInput, ADragIsSeenWhereItEndedBeforeItIsLetGo) {
    InputQueue queue;
    queue.push(event(InputKind::button, 0, true));
    queue.push(moveTo(5, 0));
    queue.push(moveTo(9, 0));
    queue.push(event(InputKind::button, 0, false));
    EXPECT_EQ(queue.takeFrame().size(), 1u);
    EXPECT_EQ(queue.takeFrame().size(), 2u);  // both moves, with the button down
    EXPECT_EQ(queue.takeFrame().size(), 1u);
}

TEST(EditorInput, NoKeyChangesTwiceInAFrame) {
    InputQueue queue;
    for (const int key : {341, 90}) queue.push(event(InputKind::key, key, true));
    for (const int key : {90, 341}) queue.push(event(InputKind::key, key, false));
    EXPECT_EQ(queue.takeFrame().size(), 2u);  // Ctrl and Z go down together
    EXPECT_EQ(queue.takeFrame().size(), 2u);
}

TEST(EditorInput, AModifierReleasedEarlyStillCounts) {
    InputQueue queue;
    queue.push(event(InputKind::key, 341, true));
    ASSERT_EQ(queue.takeFrame().size(), 1u);
    queue.push(event(InputKind::key, 90, true));
    queue.push(event(InputKind::key, 341, false));
    queue.push(event(InputKind::key, 90, false));
    EXPECT_EQ(queue.takeFrame().size(), 1u);  // Z goes down while Ctrl is
    EXPECT_EQ(queue.takeFrame().size(), 2u);
}

TEST(EditorInput, KeyNamesLeadBack) {
    int named = 0;
    for (int key = 0; key < 400; ++key) {
        const auto name = keyName(key);
        if (!name) continue;
        ++named;
        EXPECT_EQ(keyNamed(*name), key) << *name;
    }
    EXPECT_GT(named, 70);
    EXPECT_EQ(keyNamed("no such key"), std::nullopt);
}

TEST(EditorPlayScript, WhatIsWrittenReadsBack) {
    std::vector<InputEvent> events{moveTo(640.5, 12)};
    events.push_back(event(InputKind::button, 2, true));
    events.push_back(event(InputKind::key, 341, false));
    events.push_back(event(InputKind::text, 0x00E9, false));
    events.push_back(event(InputKind::text, 0x20AC, false));
    events.push_back(event(InputKind::text, 0x1F600, false));
    InputEvent wheel = moveTo(0, -1);
    wheel.kind = InputKind::wheel;
    events.push_back(wheel);
    InputEvent drop;
    drop.kind = InputKind::drop;
    drop.files = {"a b.vox", "c.svo", "caf\xE9.vox"};
    events.push_back(drop);

    std::string script;
    for (std::size_t i = 0; i < events.size(); ++i) {
        script += writeScriptLine(static_cast<long long>(i * 2), events[i]) + "\n";
    }
    const auto lines = readPlayScript(script);
    ASSERT_TRUE(lines) << lines.error().describe();
    ASSERT_EQ(lines->size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ((*lines)[i].frame, static_cast<long long>(i * 2));
        const auto& read = std::get<InputEvent>((*lines)[i].what);
        EXPECT_EQ(read.kind, events[i].kind);
        EXPECT_EQ(read.position, events[i].position);
        EXPECT_EQ(read.code, events[i].code);
        EXPECT_EQ(read.files, events[i].files);
        EXPECT_EQ(read.kind != InputKind::text && read.down, events[i].down);
    }
}

// Two clicks that were none of a double click must not become one.
TEST(EditorPlayScript, ARecordingKeepsTheTimeBetweenEvents) {
    ScriptFrames frames;
    EXPECT_EQ(frames.next(0.0), 0);
    EXPECT_EQ(frames.next(0.001), 1);  // another frame of the screen
    EXPECT_EQ(frames.next(0.6), 36);
    EXPECT_EQ(frames.next(0.601), 37);
    EXPECT_EQ(frames.next(10.0), 600);
}

TEST(LayoutProbe, NamesOfFilesMayHoldAnyBytes) {
    const test::TemporaryFolder folder;
    LayoutProbe probe(folder / "layout.json");
    ASSERT_TRUE(probe.endFrame({{"file", "caf\xE9.vox"}}));
    const auto written = nlohmann::json::parse(std::ifstream(folder / "layout.json"));
    EXPECT_TRUE(written.at("state").at("file").get<std::string>().ends_with(".vox"));
}

TEST(EditorPlayScript, AMissingFrameIsThatOfTheLineBefore) {
    const auto lines = readPlayScript(
        "{\"frame\": 4, \"move\": [1, 2]}\n\n{\"screenshot\": \"a.png\"}\n{\"quit\": true}");
    ASSERT_TRUE(lines) << lines.error().describe();
    ASSERT_EQ(lines->size(), 3u);
    EXPECT_EQ((*lines)[1].frame, 4);
    EXPECT_EQ(std::get<ScriptScreenshot>((*lines)[1].what).path, "a.png");
    EXPECT_TRUE(std::holds_alternative<ScriptQuit>((*lines)[2].what));
}

TEST(EditorPlayScript, ErrorsNameTheLine) {
    for (const char* second :
         {"{\"frame\": 1, \"move\": [1]}", "{\"frame\": 1, \"key\": \"hyper\"}", "not json",
          "{\"frame\": 1}", "{\"frame\": 0, \"quit\": true}", "{\"frame\": \"x\"}",
          "{\"button\": 3}", "{\"text\": 5}"}) {
        const auto lines =
            readPlayScript(std::string("{\"frame\": 1, \"move\": [1, 2]}\n") + second);
        ASSERT_FALSE(lines) << second;
        EXPECT_EQ(lines.error().line, 2) << second;
    }
}

TEST(EditorSettingsFile, KeepsWhatWasChosenAndSurvivesNonsense) {
    const test::TemporaryFolder folder;
    EditorSettings settings;
    settings.tool.mode = EditMode::paint;
    settings.tool.tool = ToolKind::cylinder;
    settings.input.keys["undo"] = {control('U'), key('-')};
    settings.tool.gizmo = GizmoKind::rotate;
    settings.view.proxyBox = false;
    settings.view.lockCameras = true;
    settings.window.theme = ThemeKind::light;
    settings.window.split = 0.25f;
    settings.window.dockTab = DockTab::history;
    settings.window.sideWidth = 400.0f;
    settings.window.showsDock = false;
    settings.window.turnedSections = {"Light"};
    settings.window.scale = 1.25f;
    settings.input.navigation = NavigationPreset::blender;
    settings.view.backdrop = Backdrop::sky;
    settings.view.sunShadow = true;
    settings.cameras.push_back({"Hero", 30.0, 20.0, {0.5, 0.0, -1.0}, 2.5, true});
    settings.remember(folder / "a.vox");
    settings.remember(folder / "b.vox");
    settings.remember(folder / "a.vox");
    ASSERT_EQ(settings.window.recent.size(), 2u);
    EXPECT_EQ(settings.window.recent.front().filename(), "a.vox");

    const auto path = folder / "deep" / "editor.json";
    ASSERT_TRUE(saveSettings(path, settings, {}));
    EXPECT_EQ(loadSettings(path), settings);

    EXPECT_EQ(loadSettings(folder / "none.json"), EditorSettings{});
    ASSERT_TRUE(saveSettings(path, settings, {}));
    std::ofstream(path) << "{\"tool\": 99, \"split\": \"wide\"";
    EXPECT_EQ(loadSettings(path), EditorSettings{});
    std::ofstream(path) << "{\"tool\": {\"tool\": 99}, \"window\": {\"theme\": -1, \"split\": 7}, "
                           "\"keys\": {\"undo\": [\"Hyper+Z\"], \"redo\": [\"Ctrl+R\"]}}";
    const EditorSettings clamped = loadSettings(path);
    EXPECT_EQ(clamped.tool.tool, ToolKind::brush);
    EXPECT_EQ(clamped.window.theme, ThemeKind::dark);
    EXPECT_LE(clamped.window.split, 0.85f);
    EXPECT_FALSE(clamped.input.keys.contains("undo"));
    EXPECT_EQ(clamped.input.keys.at("redo")[0], control('R'));
}

TEST(EditorSettingsFile, AValueOfAnotherTypeCostsNoOther) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "editor.json")
        << R"({"tool": {"mode": "paint", "tool": 3}, "scene": {"pace": "slow"}, "sheet": 5,
               "window": {"theme": "dusk", "scale": 1.25}, "recent": ["a.vox", 5],
               "keys": {"undo": 7, "cut": [7], "redo": ["Ctrl+R"]},
               "cameras": [5, {"name": "Hero", "yaw": "wide"}]})";
    EditorSettings expected;
    expected.tool.tool = ToolKind::fill;
    expected.window.scale = 1.25f;
    expected.input.keys["redo"] = {control('R'), Chord{}};
    expected.cameras.push_back({.name = "Hero"});
    EXPECT_EQ(loadSettings(folder / "editor.json"), expected);
}

TEST(EditorSettingsFile, WhatAnotherEditorWroteMeanwhileStays) {
    const test::TemporaryFolder folder;
    const auto path = folder / "editor.json";
    const EditorSettings before;
    EditorSettings other = before, own = before;
    other.input.keys["undo"] = {control('U'), Chord{}};
    other.cameras.push_back({.name = "Hero"});
    ASSERT_TRUE(saveSettings(path, other, before));
    own.remember(folder / "hut.vox");
    own.window.theme = ThemeKind::light;
    ASSERT_TRUE(saveSettings(path, own, before));
    EditorSettings both = own;
    both.input.keys = other.input.keys;
    both.cameras = other.cameras;
    EXPECT_EQ(loadSettings(path), both);
    // What was changed back is changed, too.
    ASSERT_TRUE(saveSettings(path, before, own));
    EXPECT_EQ(loadSettings(path).window, before.window);
    EXPECT_EQ(loadSettings(path).input.keys, other.input.keys);
}

}  // namespace
}  // namespace voxprite::editor
