#include "tests/app/editor_window.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <utility>

#include "core/io/formats.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

// How long something may take before it counts as never; generous, a busy machine is no failure.
constexpr std::chrono::seconds kEditorTooSlow(90);
constexpr std::chrono::milliseconds kBetweenLooks(20);

}  // namespace

void EditorWindow::startDisplay(glm::ivec2 screenPx) {
    ASSERT_NO_FATAL_FAILURE(server_.start(screenPx, file("")));
    ASSERT_EQ(std::system("command -v xdotool >/dev/null"), 0) << "xdotool is not installed";
}

void EditorWindow::setResolution(int dotsPerInch) {
    const std::string command = "echo 'Xft.dpi: " + std::to_string(dotsPerInch) +
                                "' | DISPLAY=" + display() + " xrdb -merge -nocpp";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

std::vector<std::string> EditorWindow::environment() const {
    return {"DISPLAY=" + display(), "XDG_CONFIG_HOME=" + file("config").string(),
            "XDG_STATE_HOME=" + file("state").string(), "LIBGL_ALWAYS_SOFTWARE=1"};
}

void EditorWindow::openFigure() {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
    ASSERT_TRUE(saveDocument(file("figure.vox"), documentOf(figure()), GameProfile{}));
    ASSERT_NO_FATAL_FAILURE(startEditor({file("figure.vox").string()}));
    await("the figure", [](const nlohmann::json& now) { return now.at("state").at("voxels") > 0; });
}

void EditorWindow::startEditor(std::vector<std::string> arguments) {
    // The tour of the first start would lie over everything.
    const std::filesystem::path settings = file("config") / "voxprite" / "editor.json";
    if (!showsTour_ && !std::filesystem::exists(settings)) {
        std::filesystem::create_directories(settings.parent_path());
        std::ofstream(settings) << R"({"window": {"tour_seen": true}})";
    }
    arguments.insert(arguments.begin(), {VOXPRITE_PROGRAM, "edit"});
    arguments.insert(arguments.end(), {"--dump-layout", file("layout.json").string(), "--record",
                                       file("record.jsonl").string()});
    std::filesystem::remove(file("layout.json"));  // what an editor before this one said
    editor_ = Process(arguments, environment(), file("editor.log"));
    await("the editor to show itself, and the file that was named",
          [](const auto& now) { return now.at("state").at("working") == false; });
}

int EditorWindow::runEditor(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {VOXPRITE_PROGRAM, "edit"});
    editor_ = Process(arguments, environment(), file("editor.log"));
    return editor_.wait();
}

std::string EditorWindow::said() const {
    return contentOf(file("editor.log"));
}

nlohmann::json EditorWindow::layout() const {
    return nlohmann::json::parse(contentOf(file("layout.json")), nullptr, false);
}

nlohmann::json EditorWindow::state() const {
    const nlohmann::json all = layout();
    return all.is_object() ? all.at("state") : nlohmann::json();
}

void EditorWindow::await(const std::string& what,
                         const std::function<bool(const nlohmann::json&)>& holds) {
    const auto deadline = std::chrono::steady_clock::now() + kEditorTooSlow;
    while (std::chrono::steady_clock::now() < deadline) {
        const nlohmann::json now = layout();
        if (now.is_object() && holds(now)) return;
        ASSERT_TRUE(editor_.running()) << "the editor ended while waiting for " << what << "\n"
                                       << said();
        std::this_thread::sleep_for(kBetweenLooks);
    }
    FAIL() << "never: " << what << "\n"
           << layout().dump() << said() << contentOf(file("record.jsonl"));
}

glm::ivec2 EditorWindow::centreOf(const std::string& item) {
    await("widget " + item, [&](const auto& now) { return now.at("items").contains(item); });
    if (HasFatalFailure()) return {0, 0};
    // A window that has just opened may still find its size: take what two looks agree about.
    std::vector<double> rect, before;
    do {
        before = rect;
        std::this_thread::sleep_for(10 * kBetweenLooks);
        const nlohmann::json all = layout();
        // A dead editor's last words do not change.
        if (!all.is_object() || !all.at("items").contains(item)) {
            await("widget " + item,
                  [&](const auto& now) { return now.at("items").contains(item); });
            if (HasFatalFailure()) return {0, 0};
            continue;
        }
        rect = all.at("items").at(item).get<std::vector<double>>();
    } while (rect.empty() || rect != before);
    return {static_cast<int>((rect[0] + rect[2]) / 2), static_cast<int>((rect[1] + rect[3]) / 2)};
}

void EditorWindow::xdotool(const std::string& arguments) const {
    const std::string command = "DISPLAY=" + display() + " xdotool " + arguments;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

void EditorWindow::moveTo(glm::ivec2 at) {
    xdotool("mousemove " + std::to_string(at.x) + " " + std::to_string(at.y));
}

void EditorWindow::click(glm::ivec2 at, int button) {
    moveTo(at);
    xdotool("click " + std::to_string(button));
}

void EditorWindow::drag(glm::ivec2 from, glm::ivec2 to, int button) {
    moveTo(from);
    xdotool("mousedown " + std::to_string(button));
    for (int i = 1; i <= 8; ++i) moveTo(from + (to - from) * i / 8);
    xdotool("mouseup " + std::to_string(button));
}

void EditorWindow::settleAt(glm::ivec2 at) {
    moveTo(at);
    await("the pointer at its place", [&](const nlohmann::json& now) {
        const nlohmann::json& pointer = now.at("state").at("pointer");
        return pointer.at(0) == at.x && pointer.at(1) == at.y;
    });
}

void EditorWindow::carry(glm::ivec2 from, glm::ivec2 to) {
    settleAt(from);
    xdotool("mousedown 1");
    settleAt(from + glm::ivec2(0, 1));
    for (int i = 1; i <= 4; ++i) settleAt(from + (to - from) * i / 4);
    settleAt(to + glm::ivec2(1, 0));  // a frame in which it lies there
    xdotool("mouseup 1");
}

void EditorWindow::clickWith(const std::string& modifier, glm::ivec2 at) {
    keyDown(modifier);
    settleAt(at + glm::ivec2(1, 0));
    click(at);
    settleAt(at + glm::ivec2(1, 0));
    keyUp(modifier);
}

void EditorWindow::key(const std::string& chord) {
    xdotool("key " + chord);
}

void EditorWindow::keyDown(const std::string& name) {
    xdotool("keydown " + name);
}

void EditorWindow::keyUp(const std::string& name) {
    xdotool("keyup " + name);
}

void EditorWindow::type(const std::string& text) {
    xdotool("type --delay 15 -- '" + text + "'");
}

}  // namespace voxprite::test
