// A crash and the start after it, in the real window.
#include "core/io/formats.h"
#include "tests/app/editor_window.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class EditorRecovery : public EditorWindow {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        start = documentOf(solidBox({12, 10, 8}, 5));
        ASSERT_TRUE(saveDocument(file("box.voxprite"), start, GameProfile{}));
    }
    // Opens the box, attaches a voxel, and waits for the copy of it.
    void editUntilCopied() {
        ASSERT_NO_FATAL_FAILURE(startEditor({file("box.voxprite").string()}));
        awaitVoxels(960);
        click(centreOf("view.edit"));
        awaitVoxels(961);
        await("a copy", [](const Json& now) { return now.at("state").at("copied") == 1; });
    }
    void awaitVoxels(int count) {
        await(std::to_string(count) + " voxels",
              [&](const Json& now) { return now.at("state").at("voxels") == count; });
    }
    void awaitDialog(const std::string& name) {
        await("dialog '" + name + "'",
              [&](const Json& now) { return now.at("state").at("dialog") == name; });
    }
    Document start;
};

TEST_F(EditorRecovery, WhatAKilledEditorHeldComesBack) {
    ASSERT_NO_FATAL_FAILURE(editUntilCopied());
    editor().kill();
    EXPECT_EQ(must(loadDocument(file("box.voxprite"))).document.models, start.models);

    ASSERT_NO_FATAL_FAILURE(startEditor({}));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("recovery"));
    click(centreOf("recovery.recover"));
    ASSERT_NO_FATAL_FAILURE(awaitVoxels(961));
    EXPECT_TRUE(state().at("unsaved"));
    EXPECT_EQ(state().at("file"), file("box.voxprite").string());
    key("ctrl+s");
    await("all to be saved", [](const Json& now) {
        const Json& state = now.at("state");
        return !state.at("unsaved") && !state.at("working");
    });
    const Document saved = must(loadDocument(file("box.voxprite"))).document;
    EXPECT_EQ(saved.models.at(0).voxels.solidCount(), 961U);
    // Nothing is left to recover.
    key("ctrl+q");
    EXPECT_EQ(editor().wait(), 0);
    ASSERT_NO_FATAL_FAILURE(startEditor({}));
    EXPECT_EQ(state().at("dialog"), "");
}

TEST_F(EditorRecovery, LaterMeansAtTheNextStartAndDiscardedIsGone) {
    ASSERT_NO_FATAL_FAILURE(editUntilCopied());
    editor().kill();
    for (const char* answer : {"recovery.later", "recovery.discard"}) {
        ASSERT_NO_FATAL_FAILURE(startEditor({}));
        ASSERT_NO_FATAL_FAILURE(awaitDialog("recovery"));
        click(centreOf(answer));
        ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
        EXPECT_EQ(state().at("voxels"), 0);
        key("ctrl+q");
        EXPECT_EQ(editor().wait(), 0);
    }
    ASSERT_NO_FATAL_FAILURE(startEditor({}));
    EXPECT_EQ(state().at("dialog"), "");
}

}  // namespace
}  // namespace voxprite::test
