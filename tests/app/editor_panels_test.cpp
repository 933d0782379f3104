// What the panels work out for themselves, without a window.
#include <gmock/gmock.h>

#include "app/editor/panels/objects.h"
#include "app/editor/panels/option_bar.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/saved_cameras.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(EditorPanels, AModelIsSharedByObjectsAndNotByFrames) {
    Document document = test::animationOf({test::figure(), test::asymmetric()});
    const auto object = std::ranges::find_if(
        document.nodes, [](const SceneNode& node) { return !node.models.empty(); });
    ASSERT_NE(object, document.nodes.end());
    object->models = {{0, 0}, {1, 1}, {2, 0}};
    EXPECT_THAT(usersOfModels(document), ElementsAre(1, 1));
    SceneNode other;
    other.models = {{0, 1}};
    document.nodes.push_back(other);
    EXPECT_THAT(usersOfModels(document), ElementsAre(1, 2));
}

TEST(EditorPanels, AViewWithoutANameGetsOneThatIsFree) {
    std::vector<SavedCamera> kept;
    const auto keep = [&] {
        SavedCamera& camera = kept.emplace_back();
        camera.name = freeViewName(std::span(kept).first(kept.size() - 1));
        return camera.name;
    };
    EXPECT_EQ(keep(), "View 1");
    EXPECT_EQ(keep(), "View 2");
    EXPECT_EQ(keep(), "View 3");
    kept.erase(kept.begin());
    EXPECT_EQ(keep(), "View 4");
    EXPECT_EQ(kept.size(), 3u);
}

TEST(EditorPanels, AClickInTheHistoryTakesThePlaceOfTheOneBefore) {
    using enum CommandId;
    CommandQueue commands;
    commands.ask(save);
    askForStep(commands, 9, 2);
    askForStep(commands, 8, 5);  // one step later
    EXPECT_THAT(commands.take(), ElementsAre(save, dropMade, undo, undo, undo))
        << "no undo is spent on what is only being made";
    askForStep(commands, 3, 1);
    askForStep(commands, 3, 4);
    EXPECT_THAT(commands.take(), ElementsAre(redo));
    askForStep(commands, 3, 3);
    EXPECT_FALSE(commands.any());
}

OptionPart part(int worth, float width, float behind) {
    OptionPart made;
    made.worth = worth;
    made.width = width;
    made.behind = behind;
    return made;
}

TEST(EditorPanels, OptionsGiveWayByWhatTheyAreWorth) {
    const std::vector<OptionPart> parts{part(1, 50, 10), part(3, 100, 10), part(2, 30, 0)};
    EXPECT_EQ(widthOf(parts), 200.0f);
    EXPECT_THAT(partsThatFit(parts, 200.0f), Each(true));
    EXPECT_THAT(partsThatFit(parts, 199.0f), ElementsAre(false, true, true));
    EXPECT_THAT(partsThatFit(parts, 139.0f), ElementsAre(false, true, false));
    // What is too wide leaves its place to the others.
    EXPECT_THAT(partsThatFit(parts, 90.0f), ElementsAre(true, false, true));
    EXPECT_THAT(partsThatFit(parts, 0.0f), Each(false));
}

}  // namespace
}  // namespace voxprite::editor
