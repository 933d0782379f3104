// What tests that are an X client themselves share.
#pragma once

#include <xcb/xcb.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace voxprite::test {

struct FreeReply {
    void operator()(void* pointer) const { std::free(pointer); }
};
template <class T>
using XReply = std::unique_ptr<T, FreeReply>;

struct Disconnect {
    void operator()(xcb_connection_t* x) const { xcb_disconnect(x); }
};
using XConnection = std::unique_ptr<xcb_connection_t, Disconnect>;

[[nodiscard]] inline xcb_window_t rootOf(xcb_connection_t* x) {
    return xcb_setup_roots_iterator(xcb_get_setup(x)).data->root;
}

[[nodiscard]] inline xcb_atom_t atom(xcb_connection_t* x, const std::string& name) {
    const XReply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(
        x, xcb_intern_atom(x, 0, static_cast<std::uint16_t>(name.size()), name.c_str()), nullptr));
    return reply->atom;
}

// A window that is never seen: who owns a selection, or gets one.
[[nodiscard]] inline xcb_window_t hiddenWindow(xcb_connection_t* x) {
    const xcb_window_t window = xcb_generate_id(x);
    xcb_create_window(x, XCB_COPY_FROM_PARENT, window, rootOf(x), 0, 0, 1, 1, 0,
                      XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, 0, nullptr);
    return window;
}

}  // namespace voxprite::test
