// A file of several entities in the window: one is chosen and opened, some are added to the scene,
// and the file itself stays what it is.
#include <fstream>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/svo_set.h"
#include "tests/app/dropped.h"
#include "tests/app/editor_window.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class EntitiesInAWindow : public EditorWindow {
  protected:
    // "guard" is figure(), "dot" has 1 voxel, "slab" has 60.
    void writeSet() {
        const Document guard = documentOf(figure()), dot = documentOf(solidBox({1, 1, 1})),
                       slab = documentOf(solidBox({5, 4, 3}));
        const GameProfile profile;
        const std::vector<SetMember> members{{guard, profile, std::nullopt, "guard"},
                                             {dot, profile, std::nullopt, "dot"},
                                             {slab, profile, std::nullopt, "slab"}};
        set_ = must(exportSvoSet(members));
        ASSERT_TRUE(writeFileAtomically(file("set.svo"), set_));
    }
    void awaitDialog(const std::string& name) {
        await("dialog " + name,
              [&](const Json& now) { return now.at("state").at("dialog") == name; });
    }
    // The row that the keys are at, and what is ticked.
    void awaitEntity(const std::string& said) {
        await(said, [&](const Json& now) {
            const Json& state = now.at("state");
            return state.contains("entities") && state.at("entities") == said;
        });
    }
    void awaitDocument(const std::string& title, std::size_t voxels) {
        await(title, [&](const Json& now) {
            const Json& state = now.at("state");
            return state.at("title") == title && state.at("voxels") == voxels &&
                   state.at("dialog") == "";
        });
    }
    void name(const std::string& path) {
        click(centreOf("browser.name"));
        key("ctrl+a");
        type(path);
    }
    [[nodiscard]] bool setIsWhole() const { return must(readFile(file("set.svo"))) == set_; }

    Bytes set_;
};

TEST_F(EntitiesInAWindow, OneIsChosenByKeysAndSavingAsksForAName) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
    ASSERT_NO_FATAL_FAILURE(writeSet());
    ASSERT_NO_FATAL_FAILURE(startEditor({file("set.svo").string()}));
    awaitDialog("entities");
    awaitEntity("guard");
    key("Up");  // there is none above
    key("Down");
    awaitEntity("dot");
    key("End");
    awaitEntity("slab");
    key("Return");
    awaitDocument("slab", 60);
    EXPECT_EQ(state().at("file"), file("set.svo").string());
    EXPECT_FALSE(state().at("unsaved"));

    key("ctrl+s");
    awaitDialog("browser");
    name(file("set.svo").string());
    click(centreOf("browser.accept"));
    await("the question", [](const Json& now) {
        return now.at("state").at("browser") ==
               "set.svo exists and holds 3 models, all of which go. Press again to replace it";
    });
    name(file("mine.voxprite").string());
    click(centreOf("browser.accept"));
    awaitDocument("mine", 60);
    EXPECT_TRUE(setIsWhole());
    const LoadedDocument mine = must(loadDocument(file("mine.voxprite")));
    EXPECT_EQ(mine.document.entity.name, "slab");
    // From here on it is a document like all others.
    key("ctrl+s");
    await("it to be saved without a question", [](const Json& now) {
        return now.at("state").at("dialog") == "" &&
               now.at("state").at("toast") == "Saved mine.voxprite";
    });
    EXPECT_TRUE(setIsWhole());
}

TEST_F(EntitiesInAWindow, OneIsChosenByTheMouseAndLeavingKeepsTheDocument) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    ASSERT_NO_FATAL_FAILURE(writeSet());
    const Json voxels = state().at("voxels");
    const auto browseToSet = [&] {
        key("ctrl+o");
        awaitDialog("browser");
        name(file("set.svo").string());
        key("Return");
        awaitDialog("entities");
    };
    browseToSet();
    key("Escape");
    awaitDialog("");
    awaitDocument("figure", voxels.get<std::size_t>());
    browseToSet();
    click(centreOf("entities.cancel"));
    awaitDocument("figure", voxels.get<std::size_t>());
    browseToSet();
    click(centreOf("entities.row.1"));
    awaitEntity("dot");
    click(centreOf("entities.accept"));
    awaitDocument("dot", 1);
    EXPECT_TRUE(setIsWhole());
}

TEST_F(EntitiesInAWindow, SomeOrAllAreAddedToTheScene) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    ASSERT_NO_FATAL_FAILURE(writeSet());
    key("ctrl+p");
    awaitDialog("palette");
    type("add a model to the scene");
    key("Return");
    awaitDialog("browser");
    name(file("set.svo").string());
    key("Return");
    awaitEntity("guard, 3 ticked");
    click(centreOf("entities.none"));
    awaitEntity("guard, 0 ticked");
    key("Return");  // there is nothing to add
    key("space");
    awaitEntity("guard, 1 ticked");
    click(centreOf("entities.row.2"));
    awaitEntity("slab, 2 ticked");
    click(centreOf("entities.accept"));
    awaitDialog("");
    await("a crowd", [](const Json& now) {
        return now.at("state").at("sprites").at("entities").get<int>() > 1;
    });
    EXPECT_EQ(state().at("title"), "figure");
    key("ctrl+q");
    EXPECT_EQ(editor().wait(), 0);
    const Json settings = Json::parse(contentOf(file("config") / "voxprite" / "editor.json"));
    const Json& extras = settings.at("scene").at("extras");
    ASSERT_EQ(extras.size(), 2u);
    EXPECT_EQ(extras[0].at("entity"), 0);
    EXPECT_EQ(extras[1].at("entity"), 2);
    EXPECT_EQ(extras[1].at("entity_name"), "slab");
    EXPECT_EQ(extras[1].at("file"), file("set.svo").string());
}

TEST_F(EntitiesInAWindow, TheCommandLineNamesOneAndIsNotAsked) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 800}));
    ASSERT_NO_FATAL_FAILURE(writeSet());
    const auto opened = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{file("set.svo").string(), "--dump-layout",
                                           file("layout.json").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEditor(arguments);
    };
    const std::string picture = file("shot.png").string();
    ASSERT_EQ(opened({"--entity", "2", "--screenshot", picture}), 0) << said();
    EXPECT_EQ(state().at("title"), "slab");
    EXPECT_EQ(state().at("dialog"), "");
    ASSERT_EQ(opened({"--screenshot", picture}), 0) << said();
    EXPECT_EQ(state().at("dialog"), "entities");
    // Played, for then the clicks follow each other at one pace: two of them open it.
    const glm::ivec2 row = centreOf("entities.row.1");
    std::ofstream(file("twice.jsonl"))
        << R"({"frame": 5, "move": [)" << row.x << ", " << row.y << "]}\n"
        << R"({"frame": 7, "button": "left", "down": true}
{"frame": 8, "button": "left", "down": false}
{"frame": 10, "button": "left", "down": true}
{"frame": 11, "button": "left", "down": false}
{"frame": 16, "quit": true})";
    ASSERT_EQ(opened({"--play", file("twice.jsonl").string()}), 0) << said();
    EXPECT_EQ(state().at("title"), "dot");
    EXPECT_EQ(opened({"--entity", "3", "--screenshot", picture}), 1);
    EXPECT_NE(said().find("3 entities (0 guard"), std::string::npos) << said();
}

TEST_F(EntitiesInAWindow, FilesAreDroppedOnTheWindow) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    ASSERT_NO_FATAL_FAILURE(writeSet());
    const glm::ivec2 middle = centreOf("view.edit");
    const auto figures = state().at("voxels").get<std::size_t>();
    ASSERT_TRUE(saveDocument(file("a box.vox"), documentOf(solidBox({2, 3, 4})), GameProfile{}));
    ASSERT_TRUE(dropped(display(), middle, {file("a box.vox")}));
    awaitDocument("a box", 24);

    // Of several the first is opened, and that is said.
    ASSERT_TRUE(dropped(display(), middle, {file("figure.vox"), file("a box.vox")}));
    awaitDocument("figure", figures);
    EXPECT_EQ(state().at("toast"), "One document at a time: figure.vox is opened");

    // What cannot be read is told, and what is there stays, with its changes.
    std::ofstream(file("broken.vox")) << "no such thing";
    await("the model under the pointer",
          [](const Json& now) { return now.at("state").contains("hovered"); });
    click(middle);
    await("an edit", [](const Json& now) { return now.at("state").at("unsaved") == true; });
    const auto edited = state().at("voxels").get<std::size_t>();
    ASSERT_TRUE(dropped(display(), middle, {file("broken.vox")}));
    awaitDialog("unsaved");
    // A question is answered before another file is dropped.
    ASSERT_TRUE(dropped(display(), middle, {file("set.svo")}));
    await("what to do first", [](const Json& now) {
        return now.at("state").at("toast") == "Close this first, then drop set.svo";
    });
    click(centreOf("unsaved.discard"));
    awaitDialog("error");
    click(centreOf("error.ok"));
    awaitDocument("figure", edited);
    EXPECT_TRUE(state().at("unsaved"));

    ASSERT_TRUE(dropped(display(), middle, {file("set.svo")}));
    click(centreOf("unsaved.discard"));
    awaitDialog("entities");
    key("Escape");
    awaitDialog("");
    awaitDocument("figure", edited);
    EXPECT_TRUE(state().at("unsaved"));
    ASSERT_TRUE(dropped(display(), middle, {file("set.svo")}));
    click(centreOf("unsaved.discard"));
    awaitEntity("guard");
    click(centreOf("entities.row.1"));
    awaitEntity("dot");
    click(centreOf("entities.accept"));
    awaitDocument("dot", 1);
    EXPECT_TRUE(setIsWhole());
}

}  // namespace
}  // namespace voxprite::test
