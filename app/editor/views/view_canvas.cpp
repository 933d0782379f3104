#include "app/editor/views/view_canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "app/editor/views/view_cube.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

// How far a notch of the wheel goes where it moves as a drag does, and the other way round.
constexpr double kPxPerNotch = 30.0;
// Moved further than this in the frame of its release, a click was a drag.
constexpr double kFlickPx = 4.0;

}  // namespace

ViewMotion motionOf(const ViewInput& input) {
    ViewMotion motion;
    const auto move = [&](CameraMove kind, glm::dvec2 px) {
        if (kind == CameraMove::orbit) motion.orbitPx += px;
        if (kind == CameraMove::pan) motion.panPx += px;
    };
    move(input.drag, input.movedPx);
    if (input.drag == CameraMove::zoom) motion.dragNotches = -input.movedPx.y / kPxPerNotch;
    if (input.roll == CameraMove::zoom) {
        motion.wheelNotches = input.invertWheel ? -input.wheel : input.wheel;
    } else {
        move(input.roll, glm::dvec2(input.wheelAcross, input.wheel) * kPxPerNotch);
    }
    return motion;
}

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
    overlay().AddImage(imguiTexture(frame().colourTexture()), min, {min.x + size.x, min.y + size.y},
                       {0, 1}, {1, 0});
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
    const HeldKeys keys{io.KeyShift, io.KeyCtrl, io.KeysDown[GLFW_KEY_SPACE]};
    const InputSettings& habits = ui.settings.input;
    input.hovered = ImGui::IsItemHovered();
    // The frame of the release, too: a fast hand has moved in it.
    const bool active = ImGui::IsItemActive() || ImGui::IsItemDeactivated();
    // What a drag does is settled as it begins: a key let go of first changes nothing.
    if (!active) drag_ = CameraMove::none;
    for (const int button : {0, 1, 2}) {
        if (active && drag_ == CameraMove::none && !pressedHere_ && ImGui::IsMouseClicked(button)) {
            drag_ = moveByDrag(habits.navigation, button, keys);
        }
    }
    input.drag = drag_;
    // A frame ends with the press of a button: what was moved in it came before.
    const bool pressedNow =
        ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    if (!pressedNow) {
        input.movedPx = {static_cast<double>(io.MouseDelta.x),
                         static_cast<double>(io.MouseDelta.y)};
    }
    input.moving = drag_ != CameraMove::none;
    input.pressed = active && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !input.moving;
    if (input.pressed) pressedHere_ = true;
    input.released = pressedHere_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    input.held = pressedHere_ && !input.released;
    if (input.released) pressedHere_ = false;
    input.roll = moveByWheel(habits.navigation, keys);
    input.invertWheel = habits.invertWheel;
    if (input.hovered || active) {
        input.wheel = static_cast<double>(io.MouseWheel);
        input.wheelAcross = static_cast<double>(io.MouseWheelH);
    }
    return input;
}

void ViewCanvas::navigate(const ViewInput& input, OrbitCamera& camera) {
    const ViewMotion motion = motionOf(input);
    const auto zoom = [&](double notches, glm::dvec2 about) {
        if (notches != 0.0) camera.zoom(notches, about, input.sizePx);
    };
    // A camera that is not moved stays what it is, bit by bit: else the view would be drawn anew.
    zoom(motion.dragNotches, glm::dvec2(input.sizePx) * 0.5);
    if (motion.orbitPx != glm::dvec2(0.0)) camera.orbit(motion.orbitPx);
    if (motion.panPx != glm::dvec2(0.0)) camera.pan(motion.panPx, input.sizePx);
    zoom(motion.wheelNotches, input.pointerPx);
}

ImVec2 ViewCanvas::cubeMiddle(const Theme& theme) const {
    const float inset = theme.px(kViewCubeRadius) + theme.px(8);
    return {corner_.x + static_cast<float>(sizePx_.x) - inset, corner_.y + inset};
}

void ViewCanvas::useViewCube(Ui& ui, ViewInput& input, OrbitCamera& camera, CameraTurn& turn) {
    const ImVec2 middle = cubeMiddle(ui.theme);
    const double radius = static_cast<double>(ui.theme.px(kViewCubeRadius));
    ui.probe.mark("view.cube", {middle.x - ui.theme.px(8), middle.y - ui.theme.px(8)},
                  {middle.x + ui.theme.px(8), middle.y + ui.theme.px(8)});
    const glm::dvec2 fromMiddle =
        input.pointerPx - glm::dvec2(static_cast<double>(middle.x - corner_.x),
                                     static_cast<double>(middle.y - corner_.y));
    const bool over = glm::length(fromMiddle) <= radius;
    const double halfEdge = static_cast<double>(ui.theme.px(kViewCubeHalfEdge));
    const auto part = viewCubePartAt(camera, halfEdge, fromMiddle);
    cubeLit_.reset();
    if (over && input.hovered && !input.moving && !input.held) cubeLit_ = part;
    if (over && input.pressed) cubePress_ = CubePress{part};
    if (over && !input.held) input.hovered = false;
    if (!cubePress_) return;

    const bool flicked = input.released && glm::length(input.movedPx) > kFlickPx;
    cubePress_->dragged =
        cubePress_->dragged || flicked || ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    if (cubePress_->dragged) {
        camera.orbit(input.movedPx);
    } else if (input.released && cubePress_->part) {
        OrbitCamera wanted = camera;
        wanted.lookFrom(glm::dvec3(*cubePress_->part));
        turn.start(camera, wanted);
    }
    if (input.released) cubePress_.reset();
    input.hovered = input.pressed = input.held = input.released = false;
}

void ViewCanvas::drawViewCube(Ui& ui, const OrbitCamera& camera) const {
    editor::drawViewCube(ui.theme, overlay(), cubeMiddle(ui.theme), camera, cubeLit_);
}

float ViewCanvas::beforeViewCube(const Theme& theme) const {
    return cubeMiddle(theme).x - theme.px(kViewCubeRadius + 8);
}

void ViewCanvas::caption(Ui& ui, const std::string& title, const std::string& whole, float endX) {
    const Theme& theme = ui.theme;
    ImFont* bold = theme.fonts.bold;
    ImFont* small = theme.fonts.small;
    const ImVec2 at(corner_.x + theme.px(12), corner_.y + theme.px(10));
    const float titleWidth = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0, title.c_str()).x;
    const float gap = theme.px(8);
    const float room = endX - at.x;
    if (titleWidth + theme.px(20) > room) return;
    std::string detail = whole;
    const auto widthOf = [&] {
        return small->CalcTextSizeA(small->FontSize, FLT_MAX, 0, detail.c_str()).x;
    };
    float detailWidth = widthOf();
    while (titleWidth + gap + detailWidth + theme.px(20) > room &&
           detail.find(' ') != detail.npos) {
        detail = detail.substr(0, detail.rfind(' '));
        detailWidth = widthOf();
    }
    if (titleWidth + gap + detailWidth + theme.px(20) > room) {
        detail.clear();
        detailWidth = -gap;
    }
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
