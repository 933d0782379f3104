// Objects, frames and sockets in the real window, by mouse and keyboard. After each step the
// document is saved and read back. At the end everything is undone, and the document is the one
// that was opened.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

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
    // Two boxes side by side, called a and b; as many more objects as are wanted show the second.
    void open(std::size_t objects = 2) {
        ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
        start = documentOf(solidBox({12, 12, 6}, 5));
        start.nodes[1].name = "a";
        start.models.push_back({solidBox({6, 12, 3}, 9), {}});
        SceneNode second = start.nodes[1];
        second.name = "b";
        second.models = {ModelKey{0, 1}};
        second.placements[0].placement.translation = {14, 0, 0};
        start.nodes[0].children = {1};
        while (start.nodes.size() <= objects) {
            start.nodes[0].children.push_back(static_cast<int>(start.nodes.size()));
            start.nodes.push_back(second);
        }
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
    void awaitGone(const std::string& item) {
        await(item + " to be gone",
              [&](const Json& now) { return !now.at("items").contains(item); });
    }
    void renameTo(const std::string& name) {
        key("F2");
        static_cast<void>(centreOf("name.typed"));
        type(name);
        key("Return");
        awaitGone("name.typed");
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

    ASSERT_NO_FATAL_FAILURE(renameTo("tail"));
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

// The row whose name is to be typed comes into sight, wherever it is.
TEST_F(ObjectsInAWindow, AnObjectOutOfSightIsRenamed) {
    ASSERT_NO_FATAL_FAILURE(open(40));
    const glm::ivec2 first = centreOf("object.1");
    click(first);
    for (int notch = 0; notch < 20; ++notch) click(first, 5);  // the wheel
    static_cast<void>(centreOf("object.40"));
    ASSERT_NO_FATAL_FAILURE(renameTo("head"));
    ASSERT_NO_FATAL_FAILURE(made("renamed at the list's other end", 1));
    EXPECT_EQ(node(1).name, "head");

    click(centreOf("object.1"));
    key("ctrl+g");
    ASSERT_NO_FATAL_FAILURE(made("grouped", 2));
    click(centreOf("object.1"));
    const int group = 41;
    const std::string row = "object." + std::to_string(group);
    const glm::ivec2 middle = centreOf(row);
    const auto left = layout().at("items").at(row).at(0).get<double>();
    click({static_cast<int>(left) + 12, middle.y});  // its arrow
    ASSERT_NO_FATAL_FAILURE(awaitGone("object.1"));
    key("Tab");
    ASSERT_NO_FATAL_FAILURE(awaitGone("panel.dock"));
    ASSERT_NO_FATAL_FAILURE(renameTo("tail"));
    ASSERT_NO_FATAL_FAILURE(made("renamed in a folded group", 3));
    EXPECT_EQ(node(1).name, "tail");
}

// A drag among so many voxels is worked out behind the window. Each frame shows another one of the
// animation.
TEST_F(ObjectsInAWindow, ALongDragEndsWhileTheAnimationPlays) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
    VoxelGrid voxels;
    for (int i = 0; i < 10 * 10 * 10; ++i) {
        voxels.set({i / 100 * 8, i / 10 % 10 * 8, i % 10 * 8}, 5);
    }
    ASSERT_TRUE(saveDocument(path(), animationOf(std::vector(7, voxels)), GameProfile{}));
    std::filesystem::create_directories(file("config") / "voxprite");
    std::ofstream(file("config") / "voxprite" / "editor.json")
        << R"({"window": {"tour_seen": true}, "view": {"frames_per_second": 60}})";
    ASSERT_NO_FATAL_FAILURE(startEditor({path().string()}));
    click(centreOf("dock.Objects"));
    click(centreOf("object.1"));
    click(centreOf("command.play"));
    const glm::ivec2 field = centreOf("object.position.x");
    carry(field, field + glm::ivec2(60, 0));
    await("the drag to be one step", [](const Json& now) {
        const Json& state = now.at("state");
        return state.at("steps") == 1 && state.at("working") == false;
    });
    ASSERT_NO_FATAL_FAILURE(made("moved", 1));
    EXPECT_GT(node(1).placements[0].placement.translation.x, 0);
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

TEST_F(ObjectsInAWindow, TheFrameWhoseLengthIsDraggedStays) {
    ASSERT_NO_FATAL_FAILURE(open());
    click(centreOf("object.1"));
    key("Insert");
    ASSERT_NO_FATAL_FAILURE(made("a frame", 1));
    click(centreOf("command.add_clip"));
    ASSERT_NO_FATAL_FAILURE(made("a clip", 2));
    click(centreOf("timeline.clipSettings"));
    click(centreOf("clip.each"));
    await("own lengths", [](const Json& now) { return now.at("state").at("steps") == 3; });
    // A click beside the settings closes them.
    const glm::ivec2 play = centreOf("command.play");
    click(play);
    await("the settings to close",
          [](const Json& now) { return !now.at("items").contains("clip.each"); });
    click(play);
    const glm::ivec2 length = centreOf("timeline.rate");
    carry(length, length + glm::ivec2(40, 0));
    ASSERT_NO_FATAL_FAILURE(made("a length", 4));
    const std::vector<int>& lengths = document.clips.at(0).durationsMilliseconds;
    ASSERT_EQ(lengths.size(), 2u);
    EXPECT_EQ(std::ranges::count(lengths, 125), 1);
}

}  // namespace
}  // namespace voxprite::test
