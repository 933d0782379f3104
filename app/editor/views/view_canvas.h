// The part of the window that shows a view: its picture, the mouse over it, looking around.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/ui.h"
#include "app/editor/views/camera_turn.h"
#include "app/editor/views/navigation.h"
#include "render/frame.h"

namespace voxprite::editor {

// What the mouse does over a view this frame; positions in pixels from the view's top left corner.
struct ViewInput {
    glm::ivec2 sizePx{1};
    glm::dvec2 pointerPx{0.0};
    std::vector<glm::dvec2> pathPx;  // as Ui::pointerPath
    bool hovered = false;
    bool pressed = false;   // the left button went down here
    bool released = false;  // it went up again
    bool held = false;      // it is down, and went down here
    bool moving = false;    // the camera is being moved
    double wheel = 0.0;     // notches over this view, upwards
    double wheelAcross = 0.0;
    // What a drag and the wheel do to the camera.
    CameraMove drag = CameraMove::none;
    CameraMove roll = CameraMove::zoom;
    glm::dvec2 movedPx{0.0};
    bool invertWheel = false;
};

// What of that moves the camera.
struct ViewMotion {
    glm::dvec2 orbitPx{0.0};
    glm::dvec2 panPx{0.0};
    // Nearer, as notches of a wheel: about the view's middle, and about the pointer.
    double dragNotches = 0.0;
    double wheelNotches = 0.0;
};
[[nodiscard]] ViewMotion motionOf(const ViewInput& input);

class ViewCanvas {
  public:
    // Shows the picture that the last render() made; `overlay` then draws over it.
    [[nodiscard]] ViewInput begin(Ui& ui, const char* name, ImVec2 min, ImVec2 size);
    // Between begin() and end().
    [[nodiscard]] ImDrawList& overlay() const { return *ImGui::GetWindowDrawList(); }
    [[nodiscard]] ImVec2 toWindow(glm::dvec2 viewPx) const {
        return {corner_.x + static_cast<float>(viewPx.x), corner_.y + static_cast<float>(viewPx.y)};
    }
    // Ends before `endX` in the window: with as much of the detail as fits, or without the title.
    void caption(Ui& ui, const std::string& title, const std::string& detail, float endX);
    [[nodiscard]] float beforeViewCube(const Theme& theme) const;
    // The cube in the corner takes what the mouse does over it out of `input`.
    void useViewCube(Ui& ui, ViewInput& input, OrbitCamera& camera, CameraTurn& turn);
    void drawViewCube(Ui& ui, const OrbitCamera& camera) const;
    void end();

    // Moves the camera as the input says.
    static void navigate(const ViewInput& input, OrbitCamera& camera);

    // The picture, at the size of the view.
    [[nodiscard]] Frame& frame();
    [[nodiscard]] glm::ivec2 sizePx() const { return sizePx_; }

  private:
    ImVec2 corner_{0, 0};
    glm::ivec2 sizePx_{1};
    bool pressedHere_ = false;
    CameraMove drag_ = CameraMove::none;
    // While the button is held that went down on the view cube.
    struct CubePress {
        std::optional<glm::ivec3> part;
        bool dragged = false;
    };
    std::optional<CubePress> cubePress_;
    std::optional<glm::ivec3> cubeLit_;
    [[nodiscard]] ImVec2 cubeMiddle(const Theme& theme) const;
    std::unique_ptr<Frame> frame_;
};

}  // namespace voxprite::editor
