#include "app/editor/window/imgui_host.h"

#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace voxprite::editor {

namespace {

void mapKeys(ImGuiIO& io) {
    const std::pair<ImGuiKey_, int> map[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                             {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                             {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                             {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                             {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                             {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                             {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                             {ImGuiKey_Home, GLFW_KEY_HOME},
                                             {ImGuiKey_End, GLFW_KEY_END},
                                             {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                             {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                             {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                             {ImGuiKey_Space, GLFW_KEY_SPACE},
                                             {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                             {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                             {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                             {ImGuiKey_A, GLFW_KEY_A},
                                             {ImGuiKey_C, GLFW_KEY_C},
                                             {ImGuiKey_V, GLFW_KEY_V},
                                             {ImGuiKey_X, GLFW_KEY_X},
                                             {ImGuiKey_Y, GLFW_KEY_Y},
                                             {ImGuiKey_Z, GLFW_KEY_Z}};
    for (const auto& [imguiKey, glfwKey] : map) io.KeyMap[imguiKey] = glfwKey;
}

}  // namespace

ImGuiHost::ImGuiHost(float likelyScale)
    : context_(ImGui::CreateContext()), likelyScale_(likelyScale) {
    likelyFonts_ = std::async(std::launch::async, [likelyScale] {
        const Fonts fonts = buildFonts(likelyScale);
        // Unfolded here, too, and kept until it is sent to the GPU.
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        return fonts;
    });
}

ImGuiHost::~ImGuiHost() {
    if (likelyFonts_.valid()) likelyFonts_.wait();
    if (window_ != nullptr) ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

Status ImGuiHost::open(Window& window) {
    likelyFonts_.wait();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the layout is ours
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    mapKeys(io);
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* user) {
        auto& host = *static_cast<ImGuiHost*>(user);
        host.clipboard_ = host.window_->clipboard();
        return host.clipboard_.c_str();
    };
    io.SetClipboardTextFn = [](void* user, const char* text) {
        static_cast<ImGuiHost*>(user)->window_->setClipboard(text);
    };
    if (!ImGui_ImplOpenGL3_Init("#version 450 core")) {
        return fail("the user interface cannot be drawn with this OpenGL driver");
    }
    window_ = &window;
    return {};
}

float ImGuiHost::scaleOf(double contentScale, const WindowSettings& settings) {
    return std::clamp(static_cast<float>(contentScale) * settings.scale, 0.5f, 5.0f);
}

Fonts ImGuiHost::fontsFor(float scale) {
    if (likelyFonts_.valid()) {
        const Fonts fonts = likelyFonts_.get();
        if (scale == likelyScale_) return fonts;
    }
    return buildFonts(scale);
}

const Theme& ImGuiHost::updateTheme(const WindowSettings& settings) {
    const ThemeKind kind = settings.theme;
    const float scale = scaleOf(window_->contentScale(), settings);
    if (!themeReady_ || scale != theme_.scale) {
        theme_.fonts = fontsFor(scale);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    if (!themeReady_ || scale != theme_.scale || kind != theme_.kind) {
        theme_ = makeTheme(kind, scale, theme_.fonts);
        themeReady_ = true;
    }
    return theme_;
}

void ImGuiHost::feed(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
        case InputKind::move:
            io.MousePos = {static_cast<float>(event.position.x),
                           static_cast<float>(event.position.y)};
            break;
        case InputKind::leave:
            // A drag that leaves the window goes on outside it.
            if (!ImGui::IsAnyMouseDown()) {
                io.MousePos = {-std::numeric_limits<float>::max(),
                               -std::numeric_limits<float>::max()};
            }
            break;
        case InputKind::button:
            if (event.code >= 0 && event.code < ImGuiMouseButton_COUNT) {
                io.MouseDown[event.code] = event.down;
            }
            break;
        case InputKind::wheel:
            io.MouseWheelH += static_cast<float>(event.position.x);
            io.MouseWheel += static_cast<float>(event.position.y);
            break;
        case InputKind::key:
            if (event.code >= 0 && event.code < IM_ARRAYSIZE(io.KeysDown)) {
                io.KeysDown[event.code] = event.down;
            }
            break;
        case InputKind::text:
            io.AddInputCharacter(static_cast<unsigned>(event.code));
            break;
        case InputKind::drop:
            break;
    }
}

void ImGuiHost::beginFrame(const std::vector<InputEvent>& events, double deltaSeconds) {
    ImGuiIO& io = ImGui::GetIO();
    const glm::ivec2 size = window_->framebufferPx();
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = static_cast<float>(std::clamp(deltaSeconds, 1e-4, 0.5));
    for (const InputEvent& event : events) feed(event);
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void ImGuiHost::endFrame(ImU32 clear) {
    ImGui::Render();
    const glm::ivec2 size = window_->framebufferPx();
    const ImVec4 colour = ImGui::ColorConvertU32ToFloat4(clear);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(colour.x, colour.y, colour.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void ImGuiHost::applyCursor() {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return window_->setCursor(CursorShape::text);
        case ImGuiMouseCursor_Hand:
            return window_->setCursor(CursorShape::hand);
        case ImGuiMouseCursor_ResizeEW:
            return window_->setCursor(CursorShape::resizeHorizontal);
        case ImGuiMouseCursor_ResizeNS:
            return window_->setCursor(CursorShape::resizeVertical);
        default:
            return window_->setCursor(CursorShape::arrow);
    }
}

}  // namespace voxprite::editor
