// The whole editor, as a hand at the mouse and keyboard meets it.
#include <fstream>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <set>
#include <sstream>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/model/entity_voxels.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

constexpr glm::ivec2 kScreen(1280, 800);

glm::ivec3 vectorOf(const Json& json) {
    return {json.at(0).get<int>(), json.at(1).get<int>(), json.at(2).get<int>()};
}

class EditorInAWindow : public EditorWindow {
  protected:
    // A solid box of 12 x 10 x 8 voxels, open in the editor.
    void openBox() {
        ASSERT_NO_FATAL_FAILURE(startDisplay(kScreen));
        document = documentOf(solidBox({12, 10, 8}, 5));
        ASSERT_TRUE(saveDocument(file("box.vox"), document, GameProfile{}));
        ASSERT_NO_FATAL_FAILURE(startEditor({file("box.vox").string()}));
        ASSERT_NO_FATAL_FAILURE(awaitVoxels(960));
    }
    void awaitVoxels(int count) {
        await(std::to_string(count) + " voxels",
              [&](const Json& now) { return now.at("state").at("voxels") == count; });
    }
    void awaitDialog(const std::string& name) {
        await("dialog '" + name + "'",
              [&](const Json& now) { return now.at("state").at("dialog") == name; });
    }
    // Moves over the model; what the editor says lies there.
    void hoverModel(glm::ivec3& voxel, glm::ivec3& normal) {
        moveTo(centreOf("view.edit"));
        await("a voxel under the pointer", [](const Json& now) {
            const Json& state = now.at("state");
            return state.contains("hovered") && !state.at("hovered").at("ground").get<bool>();
        });
        const Json hovered = state().at("hovered");
        voxel = vectorOf(hovered.at("voxel"));
        normal = vectorOf(hovered.at("normal"));
    }
    Document document;
};

TEST_F(EditorInAWindow, PlacesUndoesTunesAndExports) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    glm::ivec3 voxel(0), normal(0);
    ASSERT_NO_FATAL_FAILURE(hoverModel(voxel, normal));
    const glm::ivec3 placed = voxel + normal;
    const int colour = state().at("colour");

    click(centreOf("view.edit"));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(961));
    EXPECT_TRUE(state().at("unsaved"));
    key("ctrl+z");
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(960));
    EXPECT_FALSE(state().at("unsaved"));
    key("ctrl+y");
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(961));

    EXPECT_EQ(state().at("sigma"), 4.0);
    const glm::ivec2 slider = centreOf("inspector.sigma");
    drag(slider, {slider.x - 30, slider.y});
    await("a smaller sigma", [](const Json& now) { return now.at("state").at("sigma") < 3.0; });

    key("ctrl+e");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type(file("edited.svo").string());
    key("Return");
    await("the export", [](const Json& now) {
        return now.at("state").at("toast") == "Exported and verified edited.svo";
    });

    const Result<LoadedDocument> exported = loadDocument(file("edited.svo"));
    ASSERT_TRUE(exported) << exported.error().describe();
    EXPECT_EQ(exported->document.authored.sigma, state().at("sigma").get<double>());
    // The file counts from its minimum corner; so do both sides here.
    VoxelGrid expected = flatten(document, 0);
    ASSERT_EQ(expected.get(voxel), 5);
    expected.set(placed, static_cast<std::uint8_t>(colour));
    const VoxelGrid found = flatten(exported->document, 0);
    const glm::ivec3 shift = found.bounds().min - expected.bounds().min;
    VoxelGrid shifted;
    expected.forEachSolid([&](glm::ivec3 v, std::uint8_t value) { shifted.set(v + shift, value); });
    EXPECT_EQ(found, shifted);
}

TEST_F(EditorInAWindow, ToolsDragAcrossTheModel) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    glm::ivec3 voxel(0), normal(0);
    ASSERT_NO_FATAL_FAILURE(hoverModel(voxel, normal));
    const glm::ivec2 middle = centreOf("view.edit");
    key("r");
    drag(middle, {middle.x + 40, middle.y + 10});
    await("a furrow", [](const Json& now) { return now.at("state").at("voxels") < 959; });
    EXPECT_EQ(state().at("steps"), 1);
    key("ctrl+z");
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(960));

    // Orbit with the right button, zoom with the wheel: nothing is edited, the view changes.
    drag(middle, {middle.x + 120, middle.y}, 3);
    click(middle, 4);
    await("another voxel under the pointer", [&](const Json& now) {
        const Json& state = now.at("state");
        return state.contains("hovered") && vectorOf(state.at("hovered").at("voxel")) != voxel;
    });
    EXPECT_EQ(state().at("voxels"), 960);
    EXPECT_EQ(state().at("steps"), 0);

    key("u");
    key("t");
    drag(centreOf("view.edit"), centreOf("view.edit") + glm::ivec2(64, 16));
    key("Return");
    await("a box", [](const Json& now) { return now.at("state").at("voxels") > 961; });
    EXPECT_EQ(state().at("steps"), 1);
}

TEST_F(EditorInAWindow, AsksBeforeLosingChangesAndSaves) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    glm::ivec3 voxel(0), normal(0);
    ASSERT_NO_FATAL_FAILURE(hoverModel(voxel, normal));
    click(centreOf("view.edit"));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(961));

    key("ctrl+n");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    EXPECT_EQ(state().at("voxels"), 961);

    // Save: first a name is asked for, then the new document comes.
    key("ctrl+n");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    click(centreOf("unsaved.save"));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type(file("kept").string());
    click(centreOf("browser.accept"));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(0));
    const Result<LoadedDocument> kept = loadDocument(file("kept.voxprite"));
    ASSERT_TRUE(kept) << kept.error().describe();
    EXPECT_EQ(flatten(kept->document, 0).solidCount(), 961u);

    // An empty model begins on the ground. Then leave without saving.
    moveTo(centreOf("view.edit") + glm::ivec2(0, 40));
    await("the ground under the pointer", [](const Json& now) {
        return now.at("state").contains("hovered") && now.at("state").at("hovered").at("ground");
    });
    click(centreOf("view.edit") + glm::ivec2(0, 40));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(1));
    key("ctrl+q");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    click(centreOf("unsaved.discard"));
    EXPECT_EQ(editor().wait(), 0) << said();
}

TEST_F(EditorInAWindow, AsksBeforeReplacingWhatAnotherProgramWrote) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    const std::filesystem::path path = file("box.voxprite");
    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type(path.string());
    click(centreOf("browser.accept"));
    await("the document has that name",
          [&](const Json& now) { return now.at("state").at("file") == path.string(); });
    const std::string other = "another program's";
    ASSERT_TRUE(writeFileAtomically(path, other));

    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("changed"));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    EXPECT_EQ(readTextFile(path).value(), other);

    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("changed"));
    click(centreOf("changed.replace"));
    await("the file is ours again", [&](const Json&) { return loadDocument(path).has_value(); });
}

TEST_F(EditorInAWindow, AsksWhatVoxelsAMeshShallBecome) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    const std::filesystem::path mesh = file("box.obj");
    ASSERT_TRUE(saveDocument(mesh, document, GameProfile{}));
    const auto askForMesh = [&] {
        key("ctrl+o");
        ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
        static_cast<void>(centreOf("browser.name"));
        key("ctrl+a");
        type(mesh.string());
        click(centreOf("browser.accept"));
        ASSERT_NO_FATAL_FAILURE(awaitDialog("import"));
    };
    ASSERT_NO_FATAL_FAILURE(askForMesh());
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    EXPECT_EQ(state().at("file"), file("box.vox").string());

    // Solid, at twice the box's own resolution: twice as many voxels along each side.
    ASSERT_NO_FATAL_FAILURE(askForMesh());
    click(centreOf("import.filling.1"));
    const glm::ivec2 number = centreOf("import.resolution");
    clickWith("ctrl", number);
    key("ctrl+a");
    type("24");
    key("Return");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(8 * 960));
}

TEST_F(EditorInAWindow, ReplaysWhatWasRecorded) {
    ASSERT_NO_FATAL_FAILURE(startDisplay(kScreen));
    ASSERT_TRUE(saveDocument(file("box.vox"), documentOf(solidBox({12, 10, 8}, 5)), GameProfile{}));
    // A stroke, an undo, a dropped file that is refused, and a second stroke.
    std::ofstream(file("in.jsonl")) << R"({"frame": 3, "move": [270, 420]}
{"frame": 4, "button": "left", "down": true}
{"frame": 5, "move": [300, 425]}
{"frame": 6, "button": "left", "down": false}
{"frame": 8, "key": "left_control", "down": true}
{"frame": 8, "key": "z", "down": true}
{"frame": 9, "key": "z", "down": false}
{"frame": 9, "key": "left_control", "down": false}
{"frame": 10, "wheel": [0, 1]}
{"frame": 11, "button": "left", "down": true}
{"frame": 12, "move": [270, 430]}
{"frame": 13, "button": "left", "down": false}
{"frame": 16, "screenshot": "SHOT"}
{"frame": 17, "quit": true}
)";
    const auto replay = [&](const std::string& script, const std::string& shot) {
        std::ostringstream text;
        text << std::ifstream(file(script)).rdbuf();
        std::string lines = text.str();
        lines.replace(lines.find("SHOT"), 4, file(shot).string());
        std::ofstream(file("play.jsonl")) << lines;
        ASSERT_EQ(EditorWindow::runEditor({file("box.vox").string(), "--play",
                                           file("play.jsonl").string(), "--record",
                                           file("out.jsonl").string()}),
                  0)
            << said();
    };
    replay("in.jsonl", "first.png");
    // What was recorded is what was played, but for the commands of the script itself.
    std::vector<Json> played, recorded;
    std::ifstream in(file("in.jsonl")), out(file("out.jsonl"));
    for (std::string line; std::getline(in, line);) {
        const Json json = Json::parse(line);
        if (!json.contains("screenshot") && !json.contains("quit")) played.push_back(json);
    }
    for (std::string line; std::getline(out, line);) recorded.push_back(Json::parse(line));
    EXPECT_EQ(recorded, played);

    replay("in.jsonl", "second.png");
    const Result<Image> first = readPngFile(file("first.png"));
    const Result<Image> second = readPngFile(file("second.png"));
    ASSERT_TRUE(first && second);
    // The status bar tells a time; all above it is the same picture.
    const int above = first->height - 27;
    for (int y = 0; y < above; ++y) {
        for (int x = 0; x < first->width; ++x) ASSERT_EQ(first->at(x, y), second->at(x, y));
    }
}

// Is there anything to see, or one colour?
int coloursIn(const Image& image, const std::vector<double>& rect) {
    std::set<std::uint32_t> colours;
    for (int y = static_cast<int>(rect[1]); y < static_cast<int>(rect[3]); ++y) {
        for (int x = static_cast<int>(rect[0]); x < static_cast<int>(rect[2]); ++x) {
            const Rgba8 pixel = image.at(x, y);
            colours.insert(static_cast<std::uint32_t>(pixel.x << 16 | pixel.y << 8 | pixel.z));
        }
    }
    return static_cast<int>(colours.size());
}

// Commands have buttons in several panels and over the views: in one of them they are whole.
bool isInSomePart(const Json& items, const std::string& item) {
    const auto inner = items.at(item).get<std::vector<double>>();
    for (const auto& [part, rect] : items.items()) {
        if (!part.starts_with("panel.") && !part.starts_with("view.")) continue;
        const auto outer = rect.get<std::vector<double>>();
        if (inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] &&
            inner[3] <= outer[3]) {
            return true;
        }
    }
    return false;
}

TEST_F(EditorInAWindow, ScreenshotsAtAllSizesShowEveryPart) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({2560, 1600}));
    ASSERT_TRUE(saveDocument(file("box.vox"), busyDocument(), GameProfile{}));
    struct Case {
        const char* window;
        const char* scale;
        glm::ivec2 size;
    };
    for (const Case& each :
         {Case{"1280x800", "1", {1280, 800}}, Case{"1920x1080", "1", {1920, 1080}},
          Case{"1280x800", "2", {2560, 1600}}}) {
        ASSERT_EQ(EditorWindow::runEditor({file("box.vox").string(), "--window", each.window,
                                           "--content-scale", each.scale, "--screenshot",
                                           file("shot.png").string(), "--frames", "4",
                                           "--dump-layout", file("layout.json").string()}),
                  0)
            << said();
        const Result<Image> shot = readPngFile(file("shot.png"));
        ASSERT_TRUE(shot) << shot.error().describe();
        ASSERT_EQ(glm::ivec2(shot->width, shot->height), each.size);
        const Json items = layout().at("items");
        for (const char* part : {"panel.menu", "panel.tools", "panel.options", "panel.inspector",
                                 "panel.dock", "panel.status", "view.edit", "view.sprite"}) {
            ASSERT_TRUE(items.contains(part)) << part;
            EXPECT_GT(coloursIn(*shot, items.at(part).get<std::vector<double>>()), 8) << part;
        }
        // Widgets stay inside the panel that they belong to (the inspector scrolls).
        const auto inside = [&](const std::string& item, const char* panel, bool scrolls) {
            const auto inner = items.at(item).get<std::vector<double>>();
            const auto outer = items.at(panel).get<std::vector<double>>();
            EXPECT_GE(inner[0], outer[0]) << item;
            EXPECT_LE(inner[2], outer[2]) << item;
            EXPECT_GE(inner[1], outer[1]) << item;
            EXPECT_TRUE(scrolls || inner[3] <= outer[3]) << item;
        };
        for (const auto& [item, rect] : items.items()) {
            if (item.starts_with("inspector.")) inside(item, "panel.inspector", true);
            if (item.starts_with("options.")) inside(item, "panel.options", false);
            if (item.starts_with("command.")) {
                EXPECT_TRUE(isInSomePart(items, item)) << item;
            }
            // The swatches scroll under the panel's lower edge.
            if (item.starts_with("palette.")) {
                inside(item, "panel.dock", item.starts_with("palette.swatch"));
            }
            if (item.starts_with("status.")) inside(item, "panel.status", false);
        }
        ASSERT_GT(items.size(), 40u);
    }
}

// Before OpenGL's programs are ready, the processor casts both views (first_pictures.h).
TEST_F(EditorInAWindow, ItsFirstFrameShowsTheModelInBothViews) {
    ASSERT_NO_FATAL_FAILURE(startDisplay(kScreen));
    ASSERT_TRUE(saveDocument(file("box.vox"), busyDocument(), GameProfile{}));
    const auto shotOf = [&](std::vector<std::string> arguments, const char* frames) {
        const std::vector<std::string> more{"--window",        "1280x800",
                                            "--content-scale", "1",
                                            "--frames",        frames,
                                            "--screenshot",    file("shot.png").string(),
                                            "--dump-layout",   file("layout.json").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(EditorWindow::runEditor(arguments), 0) << said();
        return readPngFile(file("shot.png")).value_or(Image{});
    };
    const Image empty = shotOf({}, "1");
    const Image first = shotOf({file("box.vox").string()}, "1");
    const Image drawn = shotOf({file("box.vox").string()}, "4");
    ASSERT_EQ(first.pixels.size(), drawn.pixels.size());
    ASSERT_EQ(first.pixels.size(), empty.pixels.size());
    for (const char* view : {"view.edit", "view.sprite"}) {
        const auto rect = layout().at("items").at(view).get<std::vector<int>>();
        int model = 0, same = 0;
        for (int y = rect[1]; y < rect[3]; ++y)
            for (int x = rect[0]; x < rect[2]; ++x) {
                if (first.at(x, y) == empty.at(x, y)) continue;
                ++model;
                const glm::ivec4 off =
                    glm::abs(glm::ivec4(first.at(x, y)) - glm::ivec4(drawn.at(x, y)));
                // Edges, shade, shadow and handles come with the frames that follow.
                const int most = std::string_view(view) == "view.edit" ? 90 : 12;
                if (off.x <= most && off.y <= most && off.z <= most) ++same;
            }
        EXPECT_GT(model, 5000) << view;
        EXPECT_GT(same, model * 3 / 4) << view;
    }
}

TEST_F(EditorInAWindow, SaysHowLongItsStartTook) {
    ASSERT_NO_FATAL_FAILURE(startDisplay(kScreen));
    ASSERT_EQ(EditorWindow::runEditor({"--screenshot", file("shot.png").string(), "--frames", "3",
                                       "--start-times", file("times.json").string()}),
              0)
        << said();
    const Json times = Json::parse(std::ifstream(file("times.json")));
    std::vector<std::string> parts;
    double before = 0.0;
    for (const Json& mark : times) {
        parts.push_back(mark.at("part").get<std::string>());
        EXPECT_GE(mark.at("at_ms").get<double>(), before);
        before = mark.at("at_ms").get<double>();
        EXPECT_GT(mark.at("cpu_ms").get<double>(), 0.0);
    }
    EXPECT_EQ(parts, (std::vector<std::string>{"program", "window", "interface", "document",
                                               "first frame", "second frame", "third frame"}));
}

TEST_F(EditorInAWindow, FollowsTheDisplaysContentScale) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({2560, 1600}));
    const auto toolWidth = [&](const std::string& scale) {
        std::vector<std::string> arguments{"--screenshot", file("s.png").string(), "--dump-layout",
                                           file("layout.json").string()};
        if (!scale.empty()) arguments.insert(arguments.end(), {"--content-scale", scale});
        EXPECT_EQ(EditorWindow::runEditor(arguments), 0) << said();
        const auto rect = layout().at("items").at("panel.tools").get<std::vector<double>>();
        return rect[2] - rect[0];
    };
    EXPECT_EQ(toolWidth("1"), 84.0);
    EXPECT_EQ(toolWidth("1.5"), 126.0);
    EXPECT_EQ(toolWidth(""), 84.0);
    setResolution(144);
    EXPECT_EQ(toolWidth(""), 126.0);
}

TEST_F(EditorInAWindow, SaysWhyItCannotStart) {
    ASSERT_NO_FATAL_FAILURE(startDisplay(kScreen));
    EXPECT_NE(EditorWindow::runEditor({file("none.vox").string()}), 0);
    EXPECT_NE(said().find("none.vox"), std::string::npos) << said();
    EXPECT_NE(EditorWindow::runEditor({"--play", file("none.jsonl").string()}), 0);
    EXPECT_NE(said().find("none.jsonl"), std::string::npos) << said();
}

TEST_F(EditorInAWindow, PickingAColourFromTheSpriteTakesHoldOfNoHandle) {
    ASSERT_NO_FATAL_FAILURE(openBox());
    ASSERT_NE(state().at("colour"), 5);
    // The arrow that goes up from the anchor, before the box.
    const glm::ivec2 arrow = centreOf("sprite.anchor") - glm::ivec2(0, 40);
    keyDown("alt");
    carry(arrow, arrow - glm::ivec2(0, 30));
    keyUp("alt");
    settleAt(centreOf("view.edit"));
    EXPECT_EQ(state().at("colour"), 5);
    EXPECT_EQ(state().at("steps"), 0);
    EXPECT_FALSE(state().at("unsaved"));
}

}  // namespace
}  // namespace voxprite::test
