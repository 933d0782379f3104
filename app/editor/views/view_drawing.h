// Flat drawing over a view at places of its world: crisp, and no reason to cast a ray again.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/editor/views/view_canvas.h"
#include "app/editor/window/theme.h"
#include "core/base/box.h"
#include "core/sprite/camera.h"

namespace voxprite::editor {

class ViewDrawing {
  public:
    ViewDrawing(const ViewCanvas& canvas, const Camera& camera)
        : canvas_(&canvas), camera_(&camera), list_(&canvas.overlay()) {}

    // World to window pixels; nothing for what is behind the eye.
    [[nodiscard]] std::optional<ImVec2> project(glm::dvec3 world) const;
    // Pixels of the view to window pixels.
    [[nodiscard]] ImVec2 toWindow(glm::dvec2 viewPx) const { return canvas_->toWindow(viewPx); }
    void line(glm::dvec3 a, glm::dvec3 b, ImU32 colour, float width) const;
    // Entity space of the edit view.
    void face(const std::array<glm::dvec3, 4>& corners, ImU32 colour) const;
    void box(const IBox& box, ImU32 colour, float width) const;
    void boxFaces(const IBox& box, ImU32 colour) const;  // those that face the eye
    void label(const Theme& theme, ImVec2 at, const char* text) const;
    [[nodiscard]] ImDrawList& list() const { return *list_; }

  private:
    const ViewCanvas* canvas_;
    const Camera* camera_;
    ImDrawList* list_;
};

}  // namespace voxprite::editor
