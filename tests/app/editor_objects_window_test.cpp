// Objects, frames and sockets in the real window, by mouse and keyboard. After each step the
// document is saved and read back. At the end everything is undone, and the document is the one
// that was opened.
#include <gmock/gmock.h>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

class ObjectsInAWindow : public EditorWindow {
  protected:
    // Two boxes side by side, called a and b.
    void open() {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        start = documentOf(solidBox({12, 12, 6}, 5));
        start.nodes[1].name = "a";
        start.models.push_back({solidBox({6, 12, 3}, 9), {}});
        SceneNode second = start.nodes[1];
        second.name = "b";
        second.models = {ModelKey{0, 1}};
        second.placements[0].placement.translation = {14, 0, 0};
        start.nodes.push_back(second);
        start.nodes[0].children = {1, 2};
        ASSERT_TRUE(saveDocument(path(), start, GameProfile{}));
        const Result<LoadedDocument> loaded = loadDocument(path());
        ASSERT_TRUE(loaded);
        start = loaded->document;
        ASSERT_NO_FATAL_FAILURE(startEditor({path().string()}));
        click(centreOf("dock.Objects"));
        static_cast<void>(centreOf("object.2"));
    }
    [[nodiscard]] std::filesystem::path path() const { return file("a.voxprite"); }

    // The document once this many steps are in force.
    void made(const std::string& what, int count) {
        await(what, [&](const Json& now) { return now.at("state").at("steps") == count; });
        // Files are written behind the window, and come into their place whole.
        std::filesystem::remove(path());
        key("ctrl+s");
        await(what + " to be saved", [&](const Json& now) {
            return now.at("state").at("unsaved") == false && std::filesystem::exists(path());
        });
        Result<LoadedDocument> loaded = loadDocument(path());
        ASSERT_TRUE(loaded) << loaded.error().describe();
        document = std::move(loaded->document);
    }
    [[nodiscard]] const SceneNode& node(std::size_t index) const {
        return document.nodes.at(index);
    }

    Document start, document;
};

TEST_F(ObjectsInAWindow, AreEditedAsTheListShowsThemAndUndone) {
    ASSERT_NO_FATAL_FAILURE(open());

    // A linked copy of the second one shows its very model.
    click(centreOf("object.2"));
    click(centreOf("command.duplicate_linked"));
    ASSERT_NO_FATAL_FAILURE(made("a linked copy", 1));
    ASSERT_EQ(document.nodes.size(), 4u);
    EXPECT_EQ(node(3).name, "b 2");
    EXPECT_EQ(node(3).models, node(2).models);
    EXPECT_EQ(document.models, start.models);

    click(centreOf("command.mirror_object_x"));
    ASSERT_NO_FATAL_FAILURE(made("mirrored", 2));
    EXPECT_EQ(node(3).placements[0].placement.rotation.sign[0], -1);
    EXPECT_EQ(node(3).placements[0].placement.translation, glm::ivec3(20, 0, 0));
    click(centreOf("command.make_single_user"));
    ASSERT_NO_FATAL_FAILURE(made("a single user", 3));
    EXPECT_EQ(node(3).models[0].model, 2);
    EXPECT_EQ(document.models.size(), 3u);

    key("F2");
    static_cast<void>(centreOf("name.typed"));
    type("tail");
    key("Return");
    await("the end of typing",
          [](const Json& now) { return !now.at("items").contains("name.typed"); });
    ASSERT_NO_FATAL_FAILURE(made("renamed", 4));
    EXPECT_EQ(node(3).name, "tail");

    // Two into a group, the third dragged after it, then into it.
    click(centreOf("object.1"));
    clickWith("ctrl", centreOf("object.2"));
    key("ctrl+g");
    ASSERT_NO_FATAL_FAILURE(made("grouped", 5));
    EXPECT_EQ(node(4).name, "Group");
    EXPECT_THAT(node(0).children, ElementsAre(4, 3));
    EXPECT_THAT(node(4).children, ElementsAre(1, 2));
    carry(centreOf("object.3"), centreOf("object.4"));
    ASSERT_NO_FATAL_FAILURE(made("dragged into the group", 6));
    EXPECT_THAT(node(0).children, ElementsAre(4));
    EXPECT_THAT(node(4).children, ElementsAre(1, 2, 3));
    const glm::ivec2 first = centreOf("object.1");
    carry(centreOf("object.3"), first - glm::ivec2(0, 8));
    ASSERT_NO_FATAL_FAILURE(made("dragged to the top", 7));
    EXPECT_THAT(node(4).children, ElementsAre(3, 1, 2));

    const VoxelGrid before = flatten(document, 0);
    click(centreOf("object.4"));
    key("ctrl+m");
    ASSERT_NO_FATAL_FAILURE(made("merged", 8));
    EXPECT_EQ(document.nodes.size(), 2u);
    EXPECT_EQ(flatten(document, 0), before);
    key("ctrl+h");
    ASSERT_NO_FATAL_FAILURE(made("hidden", 9));
    EXPECT_TRUE(node(1).hidden);

    for (int step = 8; step >= 0; --step) {
        key("ctrl+z");
        await("an undo", [&](const Json& now) { return now.at("state").at("steps") == step; });
    }
    ASSERT_NO_FATAL_FAILURE(made("everything undone", 0));
    EXPECT_EQ(document, start);
}

TEST_F(ObjectsInAWindow, FramesAndSocketsAreMadeAndUndone) {
    ASSERT_NO_FATAL_FAILURE(open());
    EXPECT_FALSE(layout().at("items").contains("panel.timeline"));
    click(centreOf("object.1"));
    key("Insert");
    ASSERT_NO_FATAL_FAILURE(made("a frame", 1));
    EXPECT_THAT(node(1).models, ElementsAre(ModelKey{0, 0}, ModelKey{1, 2}));
    EXPECT_EQ(document.models[2], document.models[0]);

    // An empty one after it, moved to the front.
    click(centreOf("command.add_empty_frame"));
    ASSERT_NO_FATAL_FAILURE(made("an empty frame", 2));
    EXPECT_THAT(node(1).models, ElementsAre(ModelKey{0, 0}, ModelKey{1, 2}, ModelKey{2, 3}));
    carry(centreOf("timeline.frame.2"), centreOf("timeline.frame.0"));
    ASSERT_NO_FATAL_FAILURE(made("moved to the front", 3));
    EXPECT_THAT(node(1).models, ElementsAre(ModelKey{0, 3}, ModelKey{1, 0}, ModelKey{2, 2}));
    EXPECT_EQ(node(2).models, start.nodes[2].models);

    click(centreOf("command.add_clip"));
    ASSERT_NO_FATAL_FAILURE(made("a clip", 4));
    EXPECT_EQ(document.clips, (std::vector{Clip{"Clip", 0, 2, 8.0, true, {}}}));

    // A socket in the middle of the voxel that is seen there.
    key("ctrl+Page_Down");
    key("c");
    key("7");
    const glm::ivec2 middle = centreOf("view.edit");
    moveTo(middle);
    await("a voxel under the pointer", [](const Json& now) {
        const Json& state = now.at("state");
        return state.contains("hovered") && state.at("hovered").at("normal") == Json({0, 0, 1});
    });
    click(middle);
    ASSERT_NO_FATAL_FAILURE(made("a socket", 5));
    ASSERT_EQ(document.sockets.size(), 1u);
    const Json voxel = state().at("hovered").at("voxel");
    EXPECT_EQ(document.sockets[0].positions[0].positionVoxels,
              glm::dvec3(voxel[0].get<int>(), voxel[1].get<int>(), voxel[2].get<int>()) + 0.5);
    static_cast<void>(centreOf("edit.socket.0"));
    static_cast<void>(centreOf("sprite.socket.0"));

    for (int step = 4; step >= 0; --step) {
        key("ctrl+z");
        await("an undo", [&](const Json& now) { return now.at("state").at("steps") == step; });
    }
    ASSERT_NO_FATAL_FAILURE(made("everything undone", 0));
    EXPECT_EQ(document, start);
}

}  // namespace
}  // namespace voxprite::test
