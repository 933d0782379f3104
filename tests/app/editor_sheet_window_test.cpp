// Sprite sheets from the window: the same files, byte for byte, as from the command line.

#include <fstream>

#include "core/io/formats.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class SheetInAWindow : public EditorWindow {
  protected:
    void openWalk() {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        Document walk = animationOf({figure(), asymmetric()});
        walk.clips.push_back({"walk", 0, 1, 4.0, true, {}});
        ASSERT_TRUE(saveDocument(file("walk.voxprite"), walk, GameProfile{}));
        ASSERT_NO_FATAL_FAILURE(startEditor({file("walk.voxprite").string()}));
        await("the figure", [](const Json& now) { return now.at("state").at("voxels") > 0; });
    }
    void awaitDialog(const std::string& name) {
        await("dialog " + name,
              [&](const Json& now) { return now.at("state").at("dialog") == name; });
    }
    void write(const std::string& item, const std::string& text) {
        click(centreOf(item));
        key("ctrl+a");
        type(text);
    }
};

TEST_F(SheetInAWindow, WritesWhatTheCommandLineWrites) {
    ASSERT_NO_FATAL_FAILURE(openWalk());
    key("ctrl+shift+e");
    awaitDialog("sheet");
    click(centreOf("sheet.usual.0"));  // four directions
    write("sheet.pitches", "20, 50");
    click(centreOf("sheet.normals"));
    click(centreOf("sheet.depths"));
    click(centreOf("section.Views"));  // folded, so that all below is in sight
    click(centreOf("sheet.turntable"));
    write("sheet.file", file("hand.png").string());
    click(centreOf("sheet.export"));
    awaitDialog("");
    await("the news", [](const Json& now) {
        return now.at("state").at("toast").get<std::string>().starts_with("Exported hand.png");
    });

    std::filesystem::create_directory(file("typed"));
    Process program(
        {VOXPRITE_PROGRAM, "sheet", file("walk.voxprite").string(), "-o",
         file("typed/hand.png").string(), "--directions", "4", "--pitch", "20,50", "--normals",
         "--depths", "--turntable", file("typed/hand.turntable.png").string()},
        {}, file("sheet.log"));
    ASSERT_EQ(program.wait(), 0) << contentOf(file("sheet.log"));
    for (const char* name :
         {"hand.png", "hand.normals.png", "hand.depths.png", "hand.turntable.png", "hand.json"}) {
        const std::string made = contentOf(file(name));
        EXPECT_FALSE(made.empty()) << name;
        EXPECT_TRUE(made == contentOf(file("typed") / name)) << name;
    }

    // What was set is there again, in this run and in the next. All that goes is named before.
    std::ofstream(file("hand.json")) << "mine";
    std::filesystem::remove(file("hand.depths.png"));
    key("ctrl+shift+e");
    awaitDialog("sheet");
    const auto asks = [&](const std::string& question) {
        await(question,
              [&](const Json& now) { return now.at("state").at("sheet_file") == question; });
    };
    write("sheet.file", file("hand.png").string());
    click(centreOf("sheet.export"));
    asks("hand.png and 3 files beside it exist. Press again to replace them");
    EXPECT_EQ(contentOf(file("hand.json")), "mine");
    click(centreOf("sheet.turntable"));
    click(centreOf("sheet.normals"));
    std::filesystem::remove(file("hand.png"));
    write("sheet.file", file("typed/../hand.png").string());
    click(centreOf("sheet.export"));
    asks("hand.json exists. Press again to replace it");
    key("Escape");
    awaitDialog("");
    EXPECT_EQ(contentOf(file("hand.json")), "mine");
    key("ctrl+q");
    EXPECT_EQ(editor().wait(), 0);
    const Json settings = Json::parse(contentOf(file("config") / "voxprite" / "editor.json"));
    EXPECT_EQ(settings.at("sheet").at("directions"), 4);
    EXPECT_EQ(settings.at("sheet").at("pitches"), "20, 50");
    EXPECT_EQ(settings.at("sheet").at("depths"), true);
}

TEST_F(SheetInAWindow, WhatCannotBeMadeIsToldAndNotWritten) {
    ASSERT_NO_FATAL_FAILURE(openWalk());
    key("ctrl+shift+e");
    awaitDialog("sheet");
    write("sheet.frames", "7");  // there are two
    await("the reason", [](const Json& now) {
        return now.at("state").at("sheet").get<std::string>().find("frame 7") != std::string::npos;
    });
    write("sheet.frames", "x");
    await("another reason", [](const Json& now) {
        return now.at("state").at("sheet").get<std::string>().find("numbers from 0") !=
               std::string::npos;
    });
    click(centreOf("sheet.export"));
    write("sheet.frames", "1");
    await("eight sprites", [](const Json& now) {
        return now.at("state").at("sheet").get<std::string>().starts_with("8 sprites");
    });
    EXPECT_FALSE(std::filesystem::exists(file("walk.png")));
    // Beside the document, under its name.
    click(centreOf("sheet.export"));
    awaitDialog("");
    await("the news", [](const Json& now) {
        return now.at("state").at("toast").get<std::string>().starts_with("Exported walk.png");
    });
    EXPECT_TRUE(std::filesystem::exists(file("walk.png")));
    EXPECT_TRUE(std::filesystem::exists(file("walk.json")));
}

// Which frame is shown is nothing to the sheet, which shows them all.
TEST_F(SheetInAWindow, IsMadeWhileTheAnimationPlays) {
    ASSERT_NO_FATAL_FAILURE(openWalk());
    const Json first = state().at("voxels");
    key("ctrl+space");
    await("the second frame",
          [&](const Json& now) { return now.at("state").at("voxels") != first; });
    key("ctrl+shift+e");
    awaitDialog("sheet");
    await("sixteen sprites", [](const Json& now) {
        return now.at("state").at("sheet").get<std::string>().starts_with("16 sprites");
    });
}

// What ends the typing of a number, or the choice of a file, is no answer to the dialog.
TEST_F(SheetInAWindow, EnterAndEscapeAnswerWhatHasTheKeys) {
    ASSERT_NO_FATAL_FAILURE(openWalk());
    key("ctrl+shift+e");
    awaitDialog("sheet");
    clickWith("ctrl", centreOf("sheet.directions"));
    key("ctrl+a");
    type("5");
    key("Return");
    await("ten sprites", [](const Json& now) {
        return now.at("state").at("sheet").get<std::string>().starts_with("10 sprites");
    });
    EXPECT_EQ(state().at("dialog"), "sheet");
    click(centreOf("sheet.browse"));
    awaitDialog("browser");
    static_cast<void>(centreOf("browser.name"));
    key("Escape");
    awaitDialog("sheet");
    click(centreOf("sheet.browse"));
    awaitDialog("browser");
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type("chosen.png");
    key("Return");
    awaitDialog("sheet");
    // The dialog is there to be seen: Enter in the name of the file answers it.
    click(centreOf("sheet.file"));
    EXPECT_EQ(state().at("dialog"), "sheet");
    EXPECT_FALSE(std::filesystem::exists(file("chosen.png")));
    EXPECT_FALSE(std::filesystem::exists(file("walk.png")));
    key("KP_Enter");
    awaitDialog("");
    await("the news", [](const Json& now) {
        return now.at("state").at("toast").get<std::string>().starts_with("Exported chosen.png");
    });
    EXPECT_TRUE(std::filesystem::exists(file("chosen.png")));
}

TEST_F(SheetInAWindow, EveryFormatThatIsWrittenCanBeChosen) {
    ASSERT_NO_FATAL_FAILURE(openWalk());
    key("ctrl+shift+s");
    awaitDialog("browser");
    click(centreOf("browser.formats"));
    for (const std::string& ending : writtenEndings()) {
        await(ending,
              [&](const Json& now) { return now.at("items").contains("browser.format" + ending); });
    }
    // What it cannot hold is told before it is written, a line each.
    const auto note = [](const Json& now) {
        const Json& box = now.at("items").at("browser.note");
        return box[3].get<double>() - box[1].get<double>();
    };
    const double line = note(layout());
    click(centreOf("browser.format.csm"));
    await("what is left out", [&](const Json& now) {
        return now.at("items").contains("browser.note") && note(now) > 1.5 * line;
    });
    key("Escape");
    awaitDialog("");
}

}  // namespace
}  // namespace voxprite::test
