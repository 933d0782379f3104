// Of several windows that ask, one is shown and answered at a time.
#include "app/editor/panels/command_palette.h"
#include "core/io/formats.h"
#include "tests/app/editor_window.h"
#include "tests/app/x_server.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

// Asks every window of the screen that listens to it to close, as the X in its frame does.
void askToClose(const std::string& display) {
    const XConnection connection(xcb_connect(display.c_str(), nullptr));
    xcb_connection_t* const x = connection.get();
    ASSERT_EQ(xcb_connection_has_error(x), 0);
    const XReply<xcb_query_tree_reply_t> tree(
        xcb_query_tree_reply(x, xcb_query_tree(x, rootOf(x)), nullptr));
    const xcb_window_t* const windows = xcb_query_tree_children(tree.get());
    for (int k = 0; k < xcb_query_tree_children_length(tree.get()); ++k) {
        xcb_client_message_event_t message{};
        message.response_type = XCB_CLIENT_MESSAGE;
        message.format = 32;
        message.window = windows[k];
        message.type = atom(x, "WM_PROTOCOLS");
        message.data.data32[0] = atom(x, "WM_DELETE_WINDOW");
        xcb_send_event(x, 0, windows[k], 0, reinterpret_cast<const char*>(&message));
    }
    // The server has them all once it answers.
    const XReply<xcb_get_input_focus_reply_t> answer(
        xcb_get_input_focus_reply(x, xcb_get_input_focus(x), nullptr));
    ASSERT_TRUE(answer);
}

class DialogsInAWindow : public EditorWindow {
  protected:
    void openEdited() {
        ASSERT_NO_FATAL_FAILURE(openFigure());
        voxels_ = state().at("voxels");
        click(centreOf("view.edit"));
        await("an edit", [](const Json& now) { return now.at("state").at("unsaved") == true; });
    }
    void awaitDialog(const std::string& name) {
        await("dialog '" + name + "'",
              [&](const Json& now) { return now.at("state").at("dialog") == name; });
    }
    // It can be seen, and pressed.
    void awaitShown(const std::string& item) {
        await(item, [&](const Json& now) { return now.at("items").contains(item); });
    }
    int voxels_ = 0;
};

TEST_F(DialogsInAWindow, TheQuestionBeforeTheEndLiesOverAllElse) {
    ASSERT_NO_FATAL_FAILURE(openEdited());
    struct Over {
        const char* keys;
        const char* name;
        const char* item;
    };
    for (const Over& over :
         {Over{"ctrl+p", "palette", "palette.query"}, Over{"F1", "preferences", "preferences.done"},
          Over{"ctrl+shift+e", "sheet", "sheet.export"},
          Over{"ctrl+e", "browser", "browser.accept"}}) {
        key(over.keys);
        ASSERT_NO_FATAL_FAILURE(awaitDialog(over.name));
        ASSERT_NO_FATAL_FAILURE(awaitShown(over.item));
        askToClose(display());
        ASSERT_NO_FATAL_FAILURE(awaitDialog("unsaved"));
        ASSERT_NO_FATAL_FAILURE(awaitShown("unsaved.cancel"));
        EXPECT_FALSE(layout().at("items").contains(over.item)) << over.name;
        // Esc answers the question, and what lay below it stays.
        key("Escape");
        ASSERT_NO_FATAL_FAILURE(awaitDialog(over.name));
        ASSERT_NO_FATAL_FAILURE(awaitShown(over.item));
        key("Escape");
        ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    }
    askToClose(display());
    click(centreOf("unsaved.discard"));
    EXPECT_EQ(editor().wait(), 0) << said();
}

// A name was asked for on the way out, and none was given: the program stays.
TEST_F(DialogsInAWindow, WhoLeavesTheChoiceOfANameStays) {
    ASSERT_NO_FATAL_FAILURE(openEdited());
    key("ctrl+q");
    click(centreOf("unsaved.save"));
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    key("ctrl+s");
    ASSERT_NO_FATAL_FAILURE(awaitDialog("browser"));
    static_cast<void>(centreOf("browser.name"));
    key("ctrl+a");
    type(file("kept").string());
    key("KP_Enter");
    await("the document to be saved", [](const Json& now) {
        return now.at("state").at("unsaved") == false && now.at("state").at("working") == false;
    });
    click(centreOf("view.edit"));
    await("another edit", [](const Json& now) { return now.at("state").at("unsaved") == true; });
}

TEST_F(DialogsInAWindow, TheChosenCommandIsInSight) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    const auto awaitAtTop = [&](const std::string& row) {
        await(row + " right below the query", [&](const Json& now) {
            const Json& items = now.at("items");
            if (!items.contains("palette.query") || !items.contains(row)) return false;
            const double below = items.at("palette.query").at(3).get<double>();
            const double top = items.at(row).at(1).get<double>();
            return top >= below && top < below + 20.0;
        });
    };
    const auto awaitAway = [&](const std::string& row) {
        await(row + " out of sight", [&](const Json& now) {
            const Json& items = now.at("items");
            return items.at(row).at(1) < items.at("palette.query").at(1);
        });
    };
    const std::string first = std::string("palette.") + editor::commandsMatching("").front()->tag;
    key("ctrl+p");
    ASSERT_NO_FATAL_FAILURE(awaitAtTop(first));
    for (int page = 0; page < 4; ++page) key("Next");
    ASSERT_NO_FATAL_FAILURE(awaitAway(first));
    key("Escape");
    ASSERT_NO_FATAL_FAILURE(awaitDialog(""));
    key("ctrl+p");
    ASSERT_NO_FATAL_FAILURE(awaitAtTop(first));
    for (int page = 0; page < 4; ++page) key("Next");
    ASSERT_NO_FATAL_FAILURE(awaitAway(first));
    // Typed and taken back, it begins at the top again.
    type("e");
    key("BackSpace");
    ASSERT_NO_FATAL_FAILURE(awaitAtTop(first));
}

}  // namespace
}  // namespace voxprite::test
