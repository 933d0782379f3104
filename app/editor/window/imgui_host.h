// Dear ImGui between our window and our input queue: its context, its fonts, what it is fed each
// frame, and drawing what it made.
#pragma once

#include <imgui.h>

#include <future>
#include <string>
#include <vector>

#include "app/editor/settings/settings.h"
#include "app/editor/window/input.h"
#include "app/editor/window/theme.h"
#include "app/editor/window/window.h"
#include "core/base/result.h"

namespace voxprite::editor {

class ImGuiHost {
  public:
    // Lays the fonts out for a scale that is likely to be the window's, on a thread of its own:
    // until open() nothing else may touch ImGui.
    explicit ImGuiHost(float likelyScale);
    [[nodiscard]] Status open(Window& window);
    ~ImGuiHost();
    ImGuiHost(const ImGuiHost&) = delete;
    ImGuiHost& operator=(const ImGuiHost&) = delete;

    // Pixels a unit of the layout on a display of that scale.
    [[nodiscard]] static float scaleOf(double contentScale, const WindowSettings& settings);

    // Rebuilds fonts and style when the theme or the scale changed.
    const Theme& updateTheme(const WindowSettings& settings);

    void beginFrame(const std::vector<InputEvent>& events, double deltaSeconds);
    // Draws into the window's back buffer, over `clear`.
    void endFrame(ImU32 clear);
    // The cursor that the widgets under the pointer ask for.
    void applyCursor();

  private:
    void feed(const InputEvent& event);
    [[nodiscard]] Fonts fontsFor(float scale);

    Window* window_ = nullptr;  // once it is open
    ImGuiContext* context_;
    Theme theme_;
    float likelyScale_;
    std::future<Fonts> likelyFonts_;  // until they are used
    bool themeReady_ = false;
    std::string clipboard_;  // what was handed to ImGui, which keeps the pointer
};

}  // namespace voxprite::editor
