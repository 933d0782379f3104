// The scene panel, the comparison of sigmas and the sprite's picture, by mouse and keyboard.
#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "tests/app/editor_window.h"
#include "tests/app/pasted.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class EditorScene : public EditorWindow {
  protected:
    void awaitToast(const std::string& start) {
        await(start, [&](const Json& now) {
            return now.at("state").at("toast").get<std::string>().starts_with(start);
        });
    }
    void awaitSprites(int entities) {
        await(std::to_string(entities) + " entities", [&](const Json& now) {
            return now.at("state").at("sprites").at("entities") == entities;
        });
    }
};

TEST_F(EditorScene, CopiesComeShareTheirSpritesAndGo) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    ASSERT_NO_FATAL_FAILURE(awaitSprites(1));
    click(centreOf("dock.Scene"));
    click(centreOf("scene.pattern.1"));  // the grid
    ASSERT_NO_FATAL_FAILURE(awaitSprites(101));
    click(centreOf("scene.camera.frame_scene"));
    await("all in view",
          [](const Json& now) { return now.at("state").at("sprites").at("drawn") == 101; });
    EXPECT_EQ(state().at("sprites").at("draw_calls"), 1);
    // A second model, from a file, among them.
    ASSERT_TRUE(saveDocument(file("letter.vox"), documentOf(asymmetric()), GameProfile{}));
    click(centreOf("scene.add"));
    await("the browser", [](const Json& now) { return now.at("state").at("dialog") == "browser"; });
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type(file("letter.vox").string());
    key("Return");
    static_cast<void>(centreOf("scene.extra.0"));
    ASSERT_NO_FATAL_FAILURE(awaitSprites(101));
    click(centreOf("scene.pattern.0"));
    ASSERT_NO_FATAL_FAILURE(awaitSprites(1));
    EXPECT_EQ(state().at("steps"), 0);
}

TEST_F(EditorScene, ASigmaBesideOthersBecomesTheGames) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    EXPECT_EQ(state().at("sigma"), 4.0);
    click(centreOf("command.compare_four"));
    const glm::ivec2 use = centreOf("compare.1.use");
    EXPECT_EQ(state().at("sigma"), 4.0);
    click(use);
    await("sigma 2", [](const Json& now) { return now.at("state").at("sigma") == 2.0; });
    // The button went to the cell that was in force, and comes back with the undo.
    static_cast<void>(centreOf("compare.3.use"));
    key("ctrl+z");
    await("sigma 4", [](const Json& now) { return now.at("state").at("sigma") == 4.0; });
    static_cast<void>(centreOf("compare.1.use"));
    // In place: the cell in force is the profile's own.
    const glm::ivec2 number = centreOf("compare.3.sigma");
    keyDown("ctrl");  // with it, a click types
    click(number);
    keyUp("ctrl");
    key("ctrl+a");
    type("5.5");
    key("Return");
    await("sigma 5.5", [](const Json& now) { return now.at("state").at("sigma") == 5.5; });
    EXPECT_EQ(state().at("steps"), 1);
}

TEST_F(EditorScene, TheSpriteIsSavedAndCopiedWithOneKey) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    moveTo(centreOf("view.sprite"));
    key("F12");
    ASSERT_NO_FATAL_FAILURE(awaitToast("Saved figure.png"));
    const Result<Image> saved = readPngFile(file("figure.png"));
    ASSERT_TRUE(saved) << saved.error().describe();
    EXPECT_GT(saved->width, 30);
    EXPECT_GT(saved->height, 60);
    EXPECT_EQ(saved->at(0, 0).w, 0);

    key("ctrl+shift+c");
    ASSERT_NO_FATAL_FAILURE(awaitToast("Copied the sprite"));
    const Result<Bytes> bytes = readFile(file("figure.png"));
    ASSERT_TRUE(bytes);
    EXPECT_EQ(pasted(display(), "image/png"), *bytes);
    EXPECT_FALSE(pasted(display(), "TARGETS").empty());
    EXPECT_TRUE(pasted(display(), "UTF8_STRING").empty());

    click(centreOf("sprite.scale"));
    click(centreOf("sprite.scale.4"));
    key("F12");
    ASSERT_NO_FATAL_FAILURE(awaitToast("Saved figure-2.png"));
    const Result<Image> large = readPngFile(file("figure-2.png"));
    ASSERT_TRUE(large) << large.error().describe();
    ASSERT_EQ(glm::ivec2(large->width, large->height), 4 * glm::ivec2(saved->width, saved->height));
    for (int y = 0; y < large->height; ++y) {
        for (int x = 0; x < large->width; ++x) {
            ASSERT_EQ(large->at(x, y), saved->at(x / 4, y / 4));
        }
    }
}

}  // namespace
}  // namespace voxprite::test
