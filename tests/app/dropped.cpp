#include "tests/app/dropped.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstring>
#include <optional>

#include "tests/app/x_server.h"

namespace voxprite::test {
namespace {

constexpr std::chrono::seconds kNever(90);
constexpr std::uint32_t kVersion = 5;

std::string uriList(const std::vector<std::filesystem::path>& files) {
    constexpr const char* kHex = "0123456789ABCDEF";
    std::string list;
    for (const std::filesystem::path& file : files) {
        list += "file://";
        for (const char c : file.string()) {
            const auto byte = static_cast<unsigned char>(c);
            if (std::isalnum(byte) != 0 || std::strchr("/._-~", c) != nullptr) {
                list += c;
            } else {
                list += {'%', kHex[byte >> 4], kHex[byte & 15]};
            }
        }
        list += "\r\n";
    }
    return list;
}

class Source {
  public:
    Source(xcb_connection_t* x, xcb_window_t target, std::string content)
        : x_(x), window_(hiddenWindow(x)), target_(target), content_(std::move(content)) {}

    bool drop(glm::ivec2 at) {
        const xcb_atom_t selection = atom(x_, "XdndSelection");
        const xcb_atom_t copy = atom(x_, "XdndActionCopy");
        xcb_set_selection_owner(x_, window_, selection, XCB_CURRENT_TIME);
        say("XdndEnter", {window_, kVersion << 24, atom(x_, "text/uri-list"), 0, 0});
        const auto place = static_cast<std::uint32_t>(at.x << 16 | at.y);
        say("XdndPosition", {window_, 0, place, XCB_CURRENT_TIME, copy});
        const auto wanted = answer("XdndStatus");
        if (!wanted || (wanted->data.data32[1] & 1) == 0) return false;
        say("XdndDrop", {window_, 0, XCB_CURRENT_TIME, 0, 0});
        // GLFW says how many bytes it took where others say 1.
        const auto taken = answer("XdndFinished");
        return taken && taken->data.data32[1] != 0;
    }

  private:
    void say(const char* name, std::array<std::uint32_t, 5> data) {
        xcb_client_message_event_t message{};
        message.response_type = XCB_CLIENT_MESSAGE;
        message.format = 32;
        message.window = target_;
        message.type = atom(x_, name);
        std::ranges::copy(data, message.data.data32);
        xcb_send_event(x_, 0, target_, 0, reinterpret_cast<const char*>(&message));
        xcb_flush(x_);
    }

    void give(const xcb_selection_request_event_t& asked) {
        xcb_change_property(x_, XCB_PROP_MODE_REPLACE, asked.requestor, asked.property,
                            asked.target, 8, static_cast<std::uint32_t>(content_.size()),
                            content_.data());
        xcb_selection_notify_event_t notice{};
        notice.response_type = XCB_SELECTION_NOTIFY;
        notice.requestor = asked.requestor;
        notice.selection = asked.selection;
        notice.target = asked.target;
        notice.property = asked.property;
        notice.time = asked.time;
        xcb_send_event(x_, 0, asked.requestor, 0, reinterpret_cast<const char*>(&notice));
        xcb_flush(x_);
    }

    // The target's message of that name; hands over the files when they are asked for meanwhile.
    std::optional<xcb_client_message_event_t> answer(const char* name) {
        const xcb_atom_t type = atom(x_, name);
        const auto deadline = std::chrono::steady_clock::now() + kNever;
        while (std::chrono::steady_clock::now() < deadline && xcb_connection_has_error(x_) == 0) {
            const XReply<xcb_generic_event_t> event(xcb_poll_for_event(x_));
            if (!event) {
                pollfd ready{xcb_get_file_descriptor(x_), POLLIN, 0};
                ::poll(&ready, 1, 100);
                continue;
            }
            const int kind = event->response_type & 0x7F;
            if (kind == XCB_SELECTION_REQUEST) {
                give(*reinterpret_cast<const xcb_selection_request_event_t*>(event.get()));
            } else if (kind == XCB_CLIENT_MESSAGE) {
                const auto* message =
                    reinterpret_cast<const xcb_client_message_event_t*>(event.get());
                if (message->type == type) return *message;
            }
        }
        return std::nullopt;
    }

    xcb_connection_t* x_;
    xcb_window_t window_;
    xcb_window_t target_;
    std::string content_;
};

// The topmost of the screen that says it takes drops.
xcb_window_t windowForDrops(xcb_connection_t* x) {
    const XReply<xcb_query_tree_reply_t> tree(
        xcb_query_tree_reply(x, xcb_query_tree(x, rootOf(x)), nullptr));
    const xcb_window_t* const windows = xcb_query_tree_children(tree.get());
    for (int k = xcb_query_tree_children_length(tree.get()) - 1; k >= 0; --k) {
        const XReply<xcb_get_property_reply_t> aware(
            xcb_get_property_reply(x,
                                   xcb_get_property(x, 0, windows[k], atom(x, "XdndAware"),
                                                    XCB_GET_PROPERTY_TYPE_ANY, 0, 1),
                                   nullptr));
        if (aware && xcb_get_property_value_length(aware.get()) > 0) return windows[k];
    }
    return XCB_NONE;
}

}  // namespace

bool dropped(const std::string& display, glm::ivec2 at,
             const std::vector<std::filesystem::path>& files) {
    const XConnection connection(xcb_connect(display.c_str(), nullptr));
    xcb_connection_t* const x = connection.get();
    if (xcb_connection_has_error(x) != 0) return false;
    const xcb_window_t target = windowForDrops(x);
    return target != XCB_NONE && Source(x, target, uriList(files)).drop(at);
}

}  // namespace voxprite::test
