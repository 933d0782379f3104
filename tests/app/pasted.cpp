#include "tests/app/pasted.h"

#include "tests/app/x_server.h"

namespace voxprite::test {

Bytes pasted(const std::string& display, const std::string& target) {
    const XConnection connection(xcb_connect(display.c_str(), nullptr));
    xcb_connection_t* x = connection.get();
    if (xcb_connection_has_error(x) != 0) return {};
    const xcb_window_t window = hiddenWindow(x);
    const xcb_atom_t property = atom(x, "PASTED");
    xcb_convert_selection(x, window, atom(x, "CLIPBOARD"), atom(x, target), property,
                          XCB_CURRENT_TIME);
    xcb_flush(x);
    for (XReply<xcb_generic_event_t> event; event.reset(xcb_wait_for_event(x)), event;) {
        if ((event->response_type & 0x7F) != XCB_SELECTION_NOTIFY) continue;
        const auto* notice = reinterpret_cast<const xcb_selection_notify_event_t*>(event.get());
        if (notice->property == XCB_NONE) return {};
        const XReply<xcb_get_property_reply_t> reply(xcb_get_property_reply(
            x, xcb_get_property(x, 0, window, property, XCB_GET_PROPERTY_TYPE_ANY, 0, 1u << 22),
            nullptr));
        const auto* bytes = static_cast<const std::uint8_t*>(xcb_get_property_value(reply.get()));
        return {bytes, bytes + xcb_get_property_value_length(reply.get())};
    }
    return {};
}

}  // namespace voxprite::test
