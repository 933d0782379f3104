#include "app/editor/window/window.h"

#include <glad/gl.h>
// GLFW must not bring its own declarations of OpenGL.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "render/gl/context.h"

namespace voxprite::editor {

struct Window::Impl {
    GLFWwindow* window = nullptr;
    InputQueue input;
    std::optional<double> forcedScale;
    std::string title;
    std::array<GLFWcursor*, 5> cursors{};
    CursorShape cursor = CursorShape::arrow;

    ~Impl() {
        for (GLFWcursor* each : cursors) {
            if (each != nullptr) glfwDestroyCursor(each);
        }
        if (window != nullptr) glfwDestroyWindow(window);
        glfwTerminate();
    }

    // Window coordinates are not pixels everywhere.
    [[nodiscard]] glm::dvec2 pixelsFromWindow(double x, double y) const {
        int width = 1, height = 1, widthPx = 1, heightPx = 1;
        glfwGetWindowSize(window, &width, &height);
        glfwGetFramebufferSize(window, &widthPx, &heightPx);
        return {x * widthPx / std::max(width, 1), y * heightPx / std::max(height, 1)};
    }

    void push(InputEvent event) {
        event.seconds = Window::seconds();
        input.push(std::move(event));
    }
    static Impl& of(GLFWwindow* window) {
        return *static_cast<Impl*>(glfwGetWindowUserPointer(window));
    }
    void installCallbacks();
};

void Window::Impl::installCallbacks() {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push({.kind = InputKind::move, .position = of(w).pixelsFromWindow(x, y)});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered == 0) of(w).push({.kind = InputKind::leave});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        of(w).push({.kind = InputKind::button, .code = button, .down = action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push({.kind = InputKind::wheel, .position = {x, y}});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        // The user interface repeats keys by itself.
        if (key == GLFW_KEY_UNKNOWN || action == GLFW_REPEAT) return;
        of(w).push({.kind = InputKind::key, .code = key, .down = action == GLFW_PRESS});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codepoint) {
        of(w).push({.kind = InputKind::text, .code = static_cast<int>(codepoint)});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        InputEvent event{.kind = InputKind::drop};
        event.files.assign(paths, paths + count);
        of(w).push(std::move(event));
    });
}

namespace {

std::string glfwReason() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return reason != nullptr ? reason : "no reason given";
}

double displayScale() {
    float x = 1.0f, y = 1.0f;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        glfwGetMonitorContentScale(monitor, &x, &y);
    }
    return x > 0.0f ? static_cast<double>(x) : 1.0;
}

// The primary one first.
std::vector<WorkArea> workAreas() {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::vector<WorkArea> areas;
    for (int i = 0; i < count; ++i) {
        WorkArea area;
        glfwGetMonitorWorkarea(monitors[i], &area.corner.x, &area.corner.y, &area.size.x,
                               &area.size.y);
        if (area.size.x > 0 && area.size.y > 0) areas.push_back(area);
    }
    return areas;
}

}  // namespace

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::~Window() = default;
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;

Result<Window> Window::open(const std::string& title, const WindowPlace& place,
                            std::optional<double> contentScale) {
    if (glfwInit() == GLFW_FALSE) {
        return fail("no display to open a window on (" + glfwReason() +
                    "); without one, run under xvfb-run");
    }
    auto impl = std::make_unique<Impl>();
    impl->forcedScale = contentScale;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "voxprite");  // as app/desktop/voxprite.desktop says
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "voxprite");
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    const WindowPlace fitted = placeOn(workAreas(), place, contentScale.value_or(displayScale()));
    // It is shown once it is where it belongs.
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_MAXIMIZED, fitted.maximized ? GLFW_TRUE : GLFW_FALSE);
    // By EGL where there is: it is sooner ready than GLX.
    for (const int api : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
        if (impl->window != nullptr) break;
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
        impl->window =
            glfwCreateWindow(fitted.width, fitted.height, title.c_str(), nullptr, nullptr);
    }
    if (impl->window == nullptr) {
        return fail("no window with OpenGL 4.5 (" + glfwReason() + ")");
    }
    glfwSetWindowSizeLimits(impl->window, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (fitted.known && !fitted.maximized) glfwSetWindowPos(impl->window, fitted.x, fitted.y);
    glfwShowWindow(impl->window);
    glfwMakeContextCurrent(impl->window);
    glfwSwapInterval(1);
    if (const Status loaded = gl::loadCurrent(&glfwGetProcAddress); !loaded) {
        return Failure(loaded.error());
    }
    impl->cursors = {
        glfwCreateStandardCursor(GLFW_ARROW_CURSOR), glfwCreateStandardCursor(GLFW_IBEAM_CURSOR),
        glfwCreateStandardCursor(GLFW_HAND_CURSOR), glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR),
        glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR)};
    impl->installCallbacks();
    return Window(std::move(impl));
}

glm::ivec2 Window::framebufferPx() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(impl_->window, &size.x, &size.y);
    return size;
}

double Window::contentScale() const {
    if (impl_->forcedScale) return *impl_->forcedScale;
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(impl_->window, &x, &y);
    return x > 0.0f ? static_cast<double>(x) : 1.0;
}

WindowPlace Window::place(const WindowPlace& before) const {
    WindowPlace place = before;
    place.maximized = glfwGetWindowAttrib(impl_->window, GLFW_MAXIMIZED) == GLFW_TRUE;
    if (place.maximized || glfwGetWindowAttrib(impl_->window, GLFW_ICONIFIED) == GLFW_TRUE) {
        return place;
    }
    glm::ivec2 size(0);
    glfwGetWindowSize(impl_->window, &size.x, &size.y);
    glfwGetWindowPos(impl_->window, &place.x, &place.y);
    const double scale = contentScale();
    place.width = static_cast<int>(std::round(size.x / scale));
    place.height = static_cast<int>(std::round(size.y / scale));
    place.known = true;
    return place;
}

double Window::seconds() {
    return glfwGetTime();
}

void Window::pollEvents(double waitSeconds) {
    if (waitSeconds > 0.0) {
        glfwWaitEventsTimeout(waitSeconds);
    } else {
        glfwPollEvents();
    }
}

InputQueue& Window::input() {
    return impl_->input;
}

bool Window::takeCloseRequest() {
    const bool asked = glfwWindowShouldClose(impl_->window) == GLFW_TRUE;
    if (asked) glfwSetWindowShouldClose(impl_->window, GLFW_FALSE);
    return asked;
}

void Window::setTitle(const std::string& title) {
    // Said again, it would come back as an event and keep the loop awake.
    if (impl_->title == title) return;
    impl_->title = title;
    glfwSetWindowTitle(impl_->window, title.c_str());
}

void Window::setCursor(CursorShape shape) {
    if (impl_->cursor == shape) return;
    impl_->cursor = shape;
    glfwSetCursor(impl_->window, impl_->cursors[static_cast<std::size_t>(shape)]);
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(impl_->window);
    return text != nullptr ? text : "";
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(impl_->window, text.c_str());
}

void Window::swapBuffers() {
    glfwSwapBuffers(impl_->window);
}

Image Window::readBackBuffer() const {
    const glm::ivec2 size = framebufferPx();
    Image bottomFirst(size.x, size.y);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bottomFirst.pixels.data());
    Image image(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            Rgba8 pixel = bottomFirst.at(x, size.y - 1 - y);
            pixel.w = 255;
            image.at(x, y) = pixel;
        }
    }
    return image;
}

}  // namespace voxprite::editor
