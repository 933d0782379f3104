// Dear ImGui between our window and our input queue: its context, its fonts, what it is fed each
// frame, and drawing what it made.
#pragma once

#include <imgui.h>

#include <vector>

#include "app/editor/settings/settings.h"
#include "app/editor/window/input.h"
#include "app/editor/window/theme.h"
#include "app/editor/window/window.h"
#include "core/base/result.h"

namespace voxprite::editor {

class ImGuiHost {
  public:
    [[nodiscard]] static Result<ImGuiHost> create(Window& window);
    ~ImGuiHost();
    ImGuiHost(ImGuiHost&&) noexcept;
    ImGuiHost& operator=(ImGuiHost&&) = delete;

    // Rebuilds fonts and style when the theme or the scale changed.
    const Theme& updateTheme(const WindowSettings& settings);

    void beginFrame(const std::vector<InputEvent>& events, double deltaSeconds);
    // Draws into the window's back buffer, over `clear`.
    void endFrame(ImU32 clear);
    // The cursor that the widgets under the pointer ask for.
    void applyCursor();

  private:
    explicit ImGuiHost(Window& window);
    void feed(const InputEvent& event);

    Window* window_;
    ImGuiContext* context_ = nullptr;
    Theme theme_;
    bool themeReady_ = false;
    // What the clipboard hands to ImGui, which keeps the pointer; shared so that moving the host
    // leaves the pointer valid.
    struct Clipboard;
    std::unique_ptr<Clipboard> clipboard_;
};

}  // namespace voxprite::editor
