// Files in the window: what would be replaced is told, and many models go into one file.
#include <fstream>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/profile_json.h"
#include "core/io/svo_set.h"
#include "tests/app/editor_window.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class FilesInAWindow : public EditorWindow {
  protected:
    void open(const Document& document, std::vector<std::string> arguments = {}) {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        ASSERT_TRUE(saveDocument(file("model.voxprite"), document, GameProfile{}));
        arguments.insert(arguments.begin(), file("model.voxprite").string());
        ASSERT_NO_FATAL_FAILURE(startEditor(std::move(arguments)));
        await("the model", [](const Json& now) { return now.at("state").at("voxels") > 0; });
    }
    void name(const std::string& path) {
        click(centreOf("browser.name"));
        key("ctrl+a");
        type(path);
    }
    void awaitToast(const std::string& start) {
        await(start, [&](const Json& now) {
            return now.at("state").at("toast").get<std::string>().starts_with(start);
        });
    }
    void awaitDialog(const std::string& dialog) {
        await(dialog, [&](const Json& now) { return now.at("state").at("dialog") == dialog; });
    }
    [[nodiscard]] std::string asked() {
        await("a question", [](const Json& now) { return now.at("state").at("browser") != ""; });
        return state().at("browser");
    }
    [[nodiscard]] Bytes bytesOf(const std::string& name) const {
        return must(readFile(file(name)));
    }
};

TEST_F(FilesInAWindow, AllFilesThatWouldBeReplacedAreNamed) {
    ASSERT_NO_FATAL_FAILURE(open(documentOf(figure())));
    std::ofstream(file("hut.png")) << "a picture of mine";
    const Bytes mine = bytesOf("hut.png");
    key("ctrl+shift+s");
    name(file("hut.obj").string());
    click(centreOf("browser.accept"));
    EXPECT_EQ(asked(), "hut.png exists. Press again to replace it");
    EXPECT_EQ(bytesOf("hut.png"), mine);
    EXPECT_FALSE(std::filesystem::exists(file("hut.obj")));
    click(centreOf("browser.accept"));
    awaitToast("Saved hut.obj");
    EXPECT_NE(bytesOf("hut.png"), mine);

    key("ctrl+shift+s");
    name(file("hut.obj").string());
    click(centreOf("browser.accept"));
    EXPECT_EQ(asked(), "hut.png, hut.mtl and hut.obj exist. Press again to replace them");
    key("Escape");
}

TEST_F(FilesInAWindow, EachModelIsExportedAsASpriteOfItsOwn) {
    const Document document = busyDocument();
    ASSERT_NO_FATAL_FAILURE(open(document));
    key("ctrl+e");
    name(file("set.svo").string());
    click(centreOf("browser.ways"));
    click(centreOf("browser.way.1"));
    click(centreOf("browser.accept"));
    awaitToast("Exported and verified");
    const GameProfile profile;
    const std::vector<SetMember> members = modelsOneByOne(document, profile, "model");
    ASSERT_GT(members.size(), 1u);
    EXPECT_EQ(bytesOf("set.svo"), must(exportSvoSet(members)));
}

// The document's file holds little of the game profile: that is asked about, and saved, by itself.
TEST_F(FilesInAWindow, TheGameProfileIsAskedAboutAtTheEnd) {
    ASSERT_NO_FATAL_FAILURE(open(documentOf(figure())));
    click(centreOf("inspector.outline"));
    ASSERT_NO_FATAL_FAILURE(
        await("the step", [](const Json& now) { return now.at("state").at("steps") == 1; }));
    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitToast("Saved model"));

    // Not with New, which keeps it.
    key("ctrl+n");
    ASSERT_NO_FATAL_FAILURE(await(
        "another document", [](const Json& now) { return now.at("state").at("voxels") == 0; }));
    key("ctrl+q");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    click(centreOf("unsaved.save"));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    // Not to be saved after all is not to end, nor to end by the next save.
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    // It has the keys until the frame after.
    for (const int x : {300, 301, 302}) settleAt({x, 500});
    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    name(file("new.voxprite").string());
    click(centreOf("browser.accept"));
    ASSERT_NO_FATAL_FAILURE(awaitToast("Saved new"));

    key("ctrl+q");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    click(centreOf("unsaved.save"));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    name(file("game.json").string());
    click(centreOf("browser.accept"));
    EXPECT_EQ(editor().wait(), 0) << said();
    EXPECT_FALSE(must(readProfileFile(file("game.json"))).outline.enabled);
}

// The one question at the end is about the profile: the document has no change of its own.
TEST_F(FilesInAWindow, AGameProfileThatAnotherEditorChangedIsNotJustReplaced) {
    const std::filesystem::path game = file("game.json");
    ASSERT_TRUE(writeProfileFile(game, {}));
    ASSERT_NO_FATAL_FAILURE(open(documentOf(figure()), {"--profile", game.string()}));
    const int before = state().at("steps");
    click(centreOf("inspector.outline"));
    ASSERT_NO_FATAL_FAILURE(await(
        "the step", [&](const Json& now) { return now.at("state").at("steps") == before + 1; }));
    GameProfile theirs;
    theirs.sigma = 7.0;
    ASSERT_TRUE(writeProfileFile(game, theirs));

    key("ctrl+q");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
    click(centreOf("unsaved.save"));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("changed"));
    EXPECT_EQ(must(readProfileFile(game)), theirs);
    click(centreOf("changed.replace"));
    EXPECT_EQ(editor().wait(), 0) << said();
    EXPECT_FALSE(must(readProfileFile(game)).outline.enabled);
}

// Another folder: the way that was chosen stays, and the folder above is the one above.
TEST_F(FilesInAWindow, TheWayStaysInAnotherFolder) {
    const Document document = busyDocument();
    ASSERT_NO_FATAL_FAILURE(open(document));
    std::filesystem::create_directories(file("above/below/lowest"));
    std::ofstream(file("above/next.svo")) << "not really";
    std::filesystem::create_symlink("nowhere.svo", file("above/below/dangling.svo"));
    key("ctrl+e");
    await("the browser", [](const Json& now) { return now.at("items").contains("browser.ways"); });
    click(centreOf("browser.ways"));
    click(centreOf("browser.way.1"));
    name(file("above/below/lowest").string() + "/");
    key("Return");
    await("an empty folder", [](const Json& now) {
        return !now.at("items").contains("browser.entry.above") &&
               !now.at("items").contains("browser.entry.dangling.svo");
    });
    click(centreOf("browser.up"));
    static_cast<void>(centreOf("browser.entry.lowest"));
    name("..");
    key("Return");
    static_cast<void>(centreOf("browser.entry.next.svo"));
    click(centreOf("browser.up"));
    static_cast<void>(centreOf("browser.entry.above"));
    name("set.svo");
    click(centreOf("browser.accept"));
    awaitToast("Exported and verified");
    const std::vector<SetMember> members = modelsOneByOne(document, GameProfile{}, "model");
    EXPECT_EQ(bytesOf("set.svo"), must(exportSvoSet(members)));
}

}  // namespace
}  // namespace voxprite::test
