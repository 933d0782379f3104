#include "tests/app/pasted.h"

#include <xcb/xcb.h>

#include <cstdlib>
#include <memory>

namespace voxprite::test {
namespace {

struct Free {
    void operator()(void* pointer) const { std::free(pointer); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;

xcb_atom_t atom(xcb_connection_t* x, const std::string& name) {
    const Reply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(
        x, xcb_intern_atom(x, 0, static_cast<std::uint16_t>(name.size()), name.c_str()), nullptr));
    return reply->atom;
}

}  // namespace

Bytes pasted(const std::string& display, const std::string& target) {
    const std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection(
        xcb_connect(display.c_str(), nullptr), &xcb_disconnect);
    xcb_connection_t* x = connection.get();
    if (xcb_connection_has_error(x) != 0) return {};
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(x)).data->root;
    const xcb_window_t window = xcb_generate_id(x);
    xcb_create_window(x, XCB_COPY_FROM_PARENT, window, root, 0, 0, 1, 1, 0,
                      XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, 0, nullptr);
    const xcb_atom_t property = atom(x, "PASTED");
    xcb_convert_selection(x, window, atom(x, "CLIPBOARD"), atom(x, target), property,
                          XCB_CURRENT_TIME);
    xcb_flush(x);
    for (Reply<xcb_generic_event_t> event; event.reset(xcb_wait_for_event(x)), event;) {
        if ((event->response_type & 0x7F) != XCB_SELECTION_NOTIFY) continue;
        const auto* notice = reinterpret_cast<const xcb_selection_notify_event_t*>(event.get());
        if (notice->property == XCB_NONE) return {};
        const Reply<xcb_get_property_reply_t> reply(xcb_get_property_reply(
            x, xcb_get_property(x, 0, window, property, XCB_GET_PROPERTY_TYPE_ANY, 0, 1u << 22),
            nullptr));
        const auto* bytes = static_cast<const std::uint8_t*>(xcb_get_property_value(reply.get()));
        return {bytes, bytes + xcb_get_property_value_length(reply.get())};
    }
    return {};
}

}  // namespace voxprite::test
