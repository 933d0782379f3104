// Input that is played to the real window, frame by frame, and the documents that it leaves: long
// edits, file dialogs, commands of the menus.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/model/voxel_morphology.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class PlayedEditor : public EditorWindow {
  protected:
    static constexpr glm::ivec2 kInEdit{300, 420};

    void SetUp() override { ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800})); }

    void line(Json json) {
        json["frame"] = frame_;
        script_ << json.dump() << "\n";
    }
    void rest(int frames = 3) { frame_ += frames; }
    void press(const std::vector<std::string>& keys) {
        for (const std::string& key : keys) line({{"key", key}, {"down", true}});
        rest(1);
        for (const std::string& key : keys) line({{"key", key}, {"down", false}});
        rest();
    }
    void clickAt(glm::ivec2 at) {
        line({{"move", {at.x, at.y}}});
        rest(2);
        line({{"button", "left"}, {"down", true}});
        rest(1);
        line({{"button", "left"}, {"down", false}});
        rest();
    }
    void write(const std::string& text) {
        line({{"text", text}});
        rest();
    }
    void runCommand(const std::string& name) {
        press({"left_control", "p"});
        write(name);
        press({"enter"});
        rest();
    }
    void chooseFile(const std::string& name) {
        rest();
        write(file(name).string());
        press({"enter"});
    }
    void saveAs(const std::string& name) {
        press({"left_control", "left_shift", "s"});
        chooseFile(name);
    }
    // The state that the editor ended in.
    Json play(const std::string& model) {
        line({{"quit", true}});
        std::ofstream(file("play.jsonl")) << script_.str();
        EXPECT_EQ(runEditor({file(model).string(), "--window", "1280x800", "--content-scale", "1",
                             "--play", file("play.jsonl").string(), "--dump-layout",
                             file("layout.json").string()}),
                  0)
            << said();
        script_.str("");
        frame_ = 3;
        return state();
    }
    void saveBox(const std::string& name, glm::ivec3 size, std::uint8_t colour) {
        ASSERT_TRUE(saveDocument(file(name), documentOf(solidBox(size, colour)), GameProfile{}));
    }
    [[nodiscard]] VoxelGrid saved(const std::string& name) const {
        const Result<LoadedDocument> loaded = loadDocument(file(name));
        EXPECT_TRUE(loaded);
        return loaded ? flatten(loaded->document, 0) : VoxelGrid();
    }

  private:
    std::ostringstream script_;
    int frame_ = 3;
};

TEST_F(PlayedEditor, LongEditsAreUndoneAndDoneAgain) {
    constexpr glm::ivec3 kSize(70, 70, 64);
    ASSERT_NO_FATAL_FAILURE(saveBox("a.voxprite", kSize, 5));
    press({"k"});  // the bucket, with the first colour
    clickAt(kInEdit);
    saveAs("filled.voxprite");
    press({"left_control", "z"});
    saveAs("undone.voxprite");
    press({"left_control", "y"});
    press({"left_control", "a"});
    press({"right"});
    press({"page_up"});
    press({"enter"});
    saveAs("moved.voxprite");
    const Json state = play("a.voxprite");
    EXPECT_EQ(saved("filled.voxprite"), solidBox(kSize, 1));
    EXPECT_EQ(saved("undone.voxprite"), solidBox(kSize, 5));
    const VoxelGrid moved = saved("moved.voxprite");
    EXPECT_EQ(moved.solidCount(), solidBox(kSize).solidCount());
    EXPECT_EQ(moved.bounds().min.z, 1);
    EXPECT_EQ(moved.bounds().size(), kSize);
    EXPECT_NE(glm::ivec2(moved.bounds().min), glm::ivec2(0)) << "to the right, as the view has it";
    EXPECT_EQ(state.at("steps"), 2);
    EXPECT_EQ(state.at("selected"), moved.solidCount());
    EXPECT_EQ(state.at("working"), false);
}

TEST_F(PlayedEditor, SmoothsByCommand) {
    ASSERT_NO_FATAL_FAILURE(saveBox("a.voxprite", {20, 16, 12}, 5));
    runCommand("smooth");
    press({"enter"});
    saveAs("smooth.voxprite");
    (void)play("a.voxprite");
    const Result<VoxelGrid> expected = smoothed(solidBox({20, 16, 12}, 5), 1);
    ASSERT_TRUE(expected);
    EXPECT_NE(*expected, solidBox({20, 16, 12}, 5));
    EXPECT_EQ(saved("smooth.voxprite"), *expected);
}

TEST_F(PlayedEditor, FramesTheSelection) {
    VoxelGrid voxels = solidBox({40, 40, 4}, 5);
    voxels.set({20, 20, 4}, 2);
    ASSERT_TRUE(saveDocument(file("a.voxprite"), documentOf(voxels), GameProfile{}));
    const auto distance = [&](bool frames) {
        runCommand("colour after");
        runCommand("all of the colour in hand");
        if (frames) press({"period"});
        const Json state = play("a.voxprite");
        EXPECT_EQ(state.at("selected"), 1);
        return state.at("camera").at("distance").get<double>();
    };
    const double whole = distance(false), near = distance(true);
    EXPECT_LT(near, whole / 10.0);
}

TEST_F(PlayedEditor, PalettesComeFromFilesAndGoToThem) {
    ASSERT_NO_FATAL_FAILURE(saveBox("a.voxprite", {4, 4, 4}, 1));
    std::ofstream(file("in.gpl"))
        << "GIMP Palette\nName: two\n#\n10 20 30\tInk\n200 100 50\tSand\n";
    runCommand("import colours");
    chooseFile("in.gpl");
    runCommand("export colours");
    chooseFile("out.gpl");
    saveAs("b.voxprite");
    (void)play("a.voxprite");
    const Result<LoadedDocument> loaded = loadDocument(file("b.voxprite"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->document.palette.colours[1], Rgba8(10, 20, 30, 255));
    EXPECT_EQ(loaded->document.palette.names[2], "Sand");
    std::ostringstream text;
    text << std::ifstream(file("out.gpl")).rdbuf();
    EXPECT_NE(text.str().find("Ink"), std::string::npos);
    EXPECT_NE(text.str().find("200 100"), std::string::npos) << text.str();
}

TEST_F(PlayedEditor, PastedElsewhereVoxelsKeepTheirColours) {
    Document from = documentOf(solidBox({3, 3, 3}, 4));
    from.palette.colours[4] = Rgba8(1, 2, 3, 255);
    Document to = documentOf(solidBox({2, 2, 2}, 1));
    to.palette = Palette{};
    to.palette.colours[1] = Rgba8(9, 9, 9, 255);
    to.palette.colours[4] = Rgba8(77, 0, 0, 255);
    ASSERT_TRUE(saveDocument(file("from.voxprite"), from, GameProfile{}));
    ASSERT_TRUE(saveDocument(file("to.voxprite"), to, GameProfile{}));
    press({"left_control", "a"});
    press({"left_control", "c"});
    line({{"drop", {file("to.voxprite").string()}}});
    rest(6);
    press({"left_control", "v"});
    press({"page_up"});
    press({"page_up"});
    press({"enter"});
    saveAs("both.voxprite");
    (void)play("from.voxprite");
    const Result<LoadedDocument> both = loadDocument(file("both.voxprite"));
    ASSERT_TRUE(both);
    const VoxelGrid voxels = flatten(both->document, 0);
    const auto colourAt = [&](glm::ivec3 v) {
        return both->document.palette.colours[voxels.get(v)];
    };
    EXPECT_EQ(colourAt({0, 0, 0}), Rgba8(9, 9, 9, 255));
    EXPECT_EQ(colourAt({1, 1, 3}), Rgba8(1, 2, 3, 255));
    EXPECT_EQ(both->document.palette.colours[4], Rgba8(77, 0, 0, 255));
}

TEST_F(PlayedEditor, LeavesOutOfTheFileWhatNoObjectShows) {
    Document document = documentOf(solidBox({2, 2, 2}, 1));
    document.models.emplace_back();
    document.models.back().voxels = solidBox({9, 9, 9}, 2);
    ASSERT_TRUE(saveDocument(file("a.voxprite"), document, GameProfile{}));
    saveAs("b.voxprite");
    rest(4);
    const Json state = play("a.voxprite");
    const Result<LoadedDocument> saved = loadDocument(file("b.voxprite"));
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->document.models.size(), 1u);
    EXPECT_EQ(state.at("unsaved"), false);
}

}  // namespace
}  // namespace voxprite::test
