#include "render/gl/context.h"

// glad's EGL header comes first: it brings the EGL types that gl.h must not declare again.
#include <glad/egl.h>
#include <glad/gl.h>

#include <cstdlib>
#include <mutex>
#include <utility>

namespace voxprite::gl {

namespace {

// An editor takes no messages, and a driver may say the same in every frame.
constexpr std::size_t kMostMessages = 100;

struct MessageLog {
    std::mutex mutex;
    std::vector<std::string> severe;
};

// The driver may call from a thread of its own.
MessageLog& messageLog() {
    static MessageLog log;
    return log;
}

void GLAD_API_PTR onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                                 const GLchar* message, const void*) {
    if (severity != GL_DEBUG_SEVERITY_HIGH && type != GL_DEBUG_TYPE_ERROR) return;
    MessageLog& log = messageLog();
    const std::lock_guard lock(log.mutex);
    if (log.severe.size() >= kMostMessages) return;
    if (length < 0) {
        log.severe.emplace_back(message);
    } else {
        log.severe.emplace_back(message, static_cast<std::size_t>(length));
    }
}

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? reinterpret_cast<const char*>(value) : "unknown";
}

// What every pass relies on; set once, never changed by a pass.
void setConventions() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onDebugMessage, nullptr);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_DITHER);
    glDisable(GL_MULTISAMPLE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

std::string eglErrorText() {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04X", static_cast<unsigned>(eglGetError()));
    return code;
}

}  // namespace

std::vector<std::string> takeSevereMessages() {
    MessageLog& log = messageLog();
    const std::lock_guard lock(log.mutex);
    return std::exchange(log.severe, {});
}

DriverInfo driverInfo() {
    return {text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION)};
}

Status loadCurrent(GetProcAddress getProcAddress) {
    const int version = gladLoadGL(getProcAddress);
    if (version == 0) return fail("no OpenGL entry points: is a context current?");
    const int major = GLAD_VERSION_MAJOR(version);
    const int minor = GLAD_VERSION_MINOR(version);
    if (major < 4 || (major == 4 && minor < 5)) {
        return fail("OpenGL 4.5 is needed; this driver offers " + std::to_string(major) + "." +
                    std::to_string(minor) + " (" + text(GL_RENDERER) + ")");
    }
    setConventions();
    return {};
}

struct HeadlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    // The display stays initialised: another context of this process may share it.
    ~Impl() {
        if (context == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
};

namespace {

// Makes a surfaceless 4.5 core context of `display` current, or says why not.
Result<EGLContext> currentContextOf(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY) return fail("no display (" + eglErrorText() + ")");
    EGLint major = 0;
    EGLint minor = 0;
    if (!eglInitialize(display, &major, &minor)) {
        return fail("eglInitialize failed (" + eglErrorText() + ")");
    }
    if (!gladLoaderLoadEGL(display)) return fail("EGL 1.5 is needed");
    if (!eglBindAPI(EGL_OPENGL_API)) return fail("no desktop OpenGL (" + eglErrorText() + ")");
    const EGLint configWishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                   EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (!eglChooseConfig(display, configWishes, &config, 1, &configs) || configs == 0) {
        config = EGL_NO_CONFIG_KHR;
    }
    const EGLint contextWishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                    4,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    5,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_CONTEXT_OPENGL_DEBUG,
                                    EGL_TRUE,
                                    EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextWishes);
    if (context == EGL_NO_CONTEXT) {
        return fail("no OpenGL 4.5 core context (" + eglErrorText() + ")");
    }
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        const std::string code = eglErrorText();
        eglDestroyContext(display, context);
        return fail("no surfaceless context (" + code + ")");
    }
    return context;
}

struct Candidate {
    std::string name;
    EGLDisplay display;
};

// Mesa's surfaceless platform, then every device by itself (what NVIDIA's driver offers).
std::vector<Candidate> candidates() {
    std::vector<Candidate> found;
    if (GLAD_EGL_EXT_platform_base && GLAD_EGL_MESA_platform_surfaceless) {
        found.push_back(
            {"Mesa surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                          EGL_DEFAULT_DISPLAY, nullptr)});
    }
    if (GLAD_EGL_EXT_platform_base && GLAD_EGL_EXT_device_enumeration &&
        GLAD_EGL_EXT_platform_device) {
        EGLint count = 0;
        eglQueryDevicesEXT(0, nullptr, &count);
        std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
        eglQueryDevicesEXT(count, devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            found.push_back(
                {"EGL device " + std::to_string(i),
                 eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                          devices[static_cast<std::size_t>(i)], nullptr)});
        }
    }
    return found;
}

}  // namespace

Result<HeadlessContext> HeadlessContext::create() {
    if (!gladLoaderLoadEGL(EGL_NO_DISPLAY)) {
        return fail("libEGL is missing: install libegl1 (and libegl-mesa0 for software drawing)");
    }
    std::string tried;
    for (const Candidate& candidate : candidates()) {
        const Result<EGLContext> context = currentContextOf(candidate.display);
        if (!context) {
            tried += (tried.empty() ? "" : "; ") + candidate.name + ": " + context.error().message;
            continue;
        }
        auto impl = std::make_unique<Impl>();
        impl->display = candidate.display;
        impl->context = *context;
        if (const Status loaded = loadCurrent(eglGetProcAddress); !loaded) {
            tried += (tried.empty() ? "" : "; ") + candidate.name + ": " + loaded.error().message;
            continue;
        }
        return HeadlessContext(std::move(impl));
    }
    return fail("no headless OpenGL 4.5 context; install libgl1-mesa-dri and libegl-mesa0 (tried " +
                (tried.empty() ? std::string("nothing: EGL offers no platform") : tried) + ")");
}

HeadlessContext::HeadlessContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

}  // namespace voxprite::gl
