#include "app/editor/window/image_clipboard.h"

#include <xcb/xcb.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <thread>

namespace voxprite::editor {
namespace {

// What libxcb hands out is freed with free().
struct Free {
    void operator()(void* pointer) const { std::free(pointer); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;

struct Disconnect {
    void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
};

}  // namespace

// Inter-Client Communication Conventions Manual, section 2.
class ImageClipboard::Owner {
  public:
    [[nodiscard]] static Result<std::unique_ptr<Owner>> create() {
        int screenNumber = 0;
        std::unique_ptr<Owner> owner(new Owner(xcb_connect(nullptr, &screenNumber)));
        xcb_connection_t* x = owner->x_.get();
        if (xcb_connection_has_error(x) != 0) {
            return fail("There is no X11 display, whose clipboard takes pictures");
        }
        // Any screen will do: the window is never shown.
        const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(x)).data;
        owner->window_ = xcb_generate_id(x);
        xcb_create_window(x, XCB_COPY_FROM_PARENT, owner->window_, screen->root, 0, 0, 1, 1, 0,
                          XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, 0, nullptr);
        owner->clipboard_ = owner->atom("CLIPBOARD");
        owner->targets_ = owner->atom("TARGETS");
        owner->png_ = owner->atom("image/png");
        owner->quit_ = owner->atom("VOXPRITE_QUIT");
        owner->thread_ = std::jthread([raw = owner.get()] { raw->serve(); });
        return owner;
    }
    ~Owner() {
        if (!thread_.joinable()) return;
        // Wakes the thread, which waits for an event.
        xcb_client_message_event_t quit{};
        quit.response_type = XCB_CLIENT_MESSAGE;
        quit.format = 32;
        quit.window = window_;
        quit.type = quit_;
        send(window_, quit);
    }

    [[nodiscard]] Status offer(Bytes png) {
        // A transfer is one request, of which 64 bytes are more than its header.
        const std::size_t most = std::size_t{xcb_get_maximum_request_length(x_.get())} * 4 - 64;
        if (png.size() > most) return fail("The picture is too large for the clipboard");
        {
            const std::lock_guard lock(mutex_);
            held_ = std::move(png);
        }
        xcb_set_selection_owner(x_.get(), window_, clipboard_, XCB_CURRENT_TIME);
        const Reply<xcb_get_selection_owner_reply_t> reply(xcb_get_selection_owner_reply(
            x_.get(), xcb_get_selection_owner(x_.get(), clipboard_), nullptr));
        if (!reply || reply->owner != window_) return fail("Another program keeps the clipboard");
        return {};
    }

  private:
    explicit Owner(xcb_connection_t* x) : x_(x) {}

    [[nodiscard]] xcb_atom_t atom(std::string_view name) const {
        const xcb_intern_atom_cookie_t asked =
            xcb_intern_atom(x_.get(), 0, static_cast<std::uint16_t>(name.size()), name.data());
        const Reply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(x_.get(), asked, nullptr));
        return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
    }
    template <class Event>
    void send(xcb_window_t to, const Event& event) const {
        std::array<char, 32> bytes{};  // every event is that long on the wire
        static_assert(sizeof(event) <= bytes.size());
        std::memcpy(bytes.data(), &event, sizeof(event));
        xcb_send_event(x_.get(), 0, to, XCB_EVENT_MASK_NO_EVENT, bytes.data());
        xcb_flush(x_.get());
    }

    void serve() {
        using Event = xcb_generic_event_t;
        for (Reply<Event> event; event.reset(xcb_wait_for_event(x_.get())), event;) {
            switch (event->response_type & 0x7F) {
                case XCB_SELECTION_REQUEST:
                    answer(*reinterpret_cast<const xcb_selection_request_event_t*>(event.get()));
                    break;
                case XCB_SELECTION_CLEAR: {  // somebody else copied something
                    const std::lock_guard lock(mutex_);
                    held_.clear();
                    break;
                }
                case XCB_CLIENT_MESSAGE:
                    if (reinterpret_cast<const xcb_client_message_event_t*>(event.get())->type ==
                        quit_) {
                        return;
                    }
                    break;
                default:
                    break;
            }
        }
    }

    void answer(const xcb_selection_request_event_t& request) {
        xcb_selection_notify_event_t notice{};
        notice.response_type = XCB_SELECTION_NOTIFY;
        notice.time = request.time;
        notice.requestor = request.requestor;
        notice.selection = request.selection;
        notice.target = request.target;
        // Old programs name no property.
        notice.property = request.property != XCB_NONE ? request.property : request.target;
        const std::lock_guard lock(mutex_);
        if (request.target == targets_) {
            const std::array<xcb_atom_t, 2> known{targets_, png_};
            put(request.requestor, notice.property, XCB_ATOM_ATOM, 32, known.size(), known.data());
        } else if (request.target == png_ && !held_.empty()) {
            put(request.requestor, notice.property, png_, 8, held_.size(), held_.data());
        } else {
            notice.property = XCB_NONE;  // refused
        }
        send(request.requestor, notice);
    }
    void put(xcb_window_t window, xcb_atom_t property, xcb_atom_t type, std::uint8_t bits,
             std::size_t count, const void* data) const {
        xcb_change_property(x_.get(), XCB_PROP_MODE_REPLACE, window, property, type, bits,
                            static_cast<std::uint32_t>(count), data);
    }

    std::unique_ptr<xcb_connection_t, Disconnect> x_;
    xcb_window_t window_ = 0;
    xcb_atom_t clipboard_ = 0, targets_ = 0, png_ = 0, quit_ = 0;
    std::mutex mutex_;
    Bytes held_;           // guarded by mutex_
    std::jthread thread_;  // ends before what it uses goes
};

ImageClipboard::ImageClipboard() = default;
ImageClipboard::~ImageClipboard() = default;
ImageClipboard::ImageClipboard(ImageClipboard&&) noexcept = default;
ImageClipboard& ImageClipboard::operator=(ImageClipboard&&) noexcept = default;

Status ImageClipboard::copyPng(Bytes png) {
    if (!owner_) {
        Result<std::unique_ptr<Owner>> owner = Owner::create();
        if (!owner) return Failure(owner.error());
        owner_ = std::move(*owner);
    }
    return owner_->offer(std::move(png));
}

}  // namespace voxprite::editor
