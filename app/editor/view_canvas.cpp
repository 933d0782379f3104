#include "app/editor/view_canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace voxprite::editor {

Frame& ViewCanvas::frame() {
    if (!frame_) frame_ = std::make_unique<Frame>(sizePx_);
    frame_->resize(sizePx_);
    return *frame_;
}

ViewInput ViewCanvas::begin(Ui& ui, const char* name, ImVec2 min, ImVec2 size) {
    corner_ = min;
    sizePx_ = {std::max(1, static_cast<int>(size.x)), std::max(1, static_cast<int>(size.y))};
    ImGui::SetNextWindowPos(min);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    // The texture's rows run upward.
    const auto texture = static_cast<std::uintptr_t>(frame().colourTexture());
    overlay().AddImage(reinterpret_cast<ImTextureID>(texture), min,
                       {min.x + size.x, min.y + size.y}, {0, 1}, {1, 0});
    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton("canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.probe.mark(name, min, {min.x + size.x, min.y + size.y});

    const ImGuiIO& io = ImGui::GetIO();
    ViewInput input;
    input.sizePx = sizePx_;
    input.pointerPx = {static_cast<double>(io.MousePos.x - min.x),
                       static_cast<double>(io.MousePos.y - min.y)};
    for (const glm::dvec2 at : ui.pointerPath) {
        input.pathPx.push_back(at -
                               glm::dvec2(static_cast<double>(min.x), static_cast<double>(min.y)));
    }
    const bool space = io.KeysDown[GLFW_KEY_SPACE];
    input.hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    input.pressed = active && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !space;
    if (input.pressed) pressedHere_ = true;
    input.released = pressedHere_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    input.held = pressedHere_ && !input.released;
    if (input.released) pressedHere_ = false;
    input.moving = active && !input.held && !input.released;
    if (input.hovered || active) input.wheel = static_cast<double>(io.MouseWheel);
    return input;
}

void ViewCanvas::navigate(ViewInput& input, OrbitCamera& camera) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 moved(static_cast<double>(io.MouseDelta.x),
                           static_cast<double>(io.MouseDelta.y));
    if (input.moving) {
        const bool pan = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                         ImGui::IsMouseDown(ImGuiMouseButton_Left);
        if (pan) {
            camera.pan(moved, input.sizePx);
        } else {
            camera.orbit(moved);
        }
    }
    if (input.wheel != 0.0) camera.zoom(input.wheel, input.pointerPx, input.sizePx);
}

void ViewCanvas::caption(Ui& ui, const std::string& title, const std::string& detail) {
    const Theme& theme = ui.theme;
    ImFont* bold = theme.fonts.bold;
    ImFont* small = theme.fonts.small;
    const ImVec2 at(corner_.x + theme.px(12), corner_.y + theme.px(10));
    const float titleWidth = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, title.c_str()).x;
    const float detailWidth = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0, detail.c_str()).x;
    const float gap = detail.empty() ? 0.0f : theme.px(8);
    const ImVec2 max(at.x + titleWidth + gap + detailWidth + theme.px(20), at.y + theme.px(26));
    overlay().AddRectFilled(at, max, IM_COL32(16, 17, 19, 150), theme.px(6));
    overlay().AddText(bold, bold->FontSize, {at.x + theme.px(10), at.y + theme.px(5)},
                      IM_COL32(240, 241, 243, 255), title.c_str());
    overlay().AddText(small, small->FontSize,
                      {at.x + theme.px(10) + titleWidth + gap, at.y + theme.px(7)},
                      IM_COL32(200, 203, 208, 255), detail.c_str());
}

void ViewCanvas::end() {
    ImGui::End();
}

}  // namespace voxprite::editor
