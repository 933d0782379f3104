// Handles over the edit view: small squares that are dragged along an axis.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "app/editor/views/view_drawing.h"
#include "core/sprite/camera.h"

namespace voxprite::editor {

struct Handle {
    glm::dvec3 at{0.0};  // entity space
    int axis = 0;        // along which it is dragged
    bool operator==(const Handle&) const = default;
};

// The handle under the pointer, the nearest to it if there are several; -1 when there is none.
[[nodiscard]] int handleAt(std::span<const Handle> handles, const Camera& camera,
                           glm::dvec2 pointerPx, float scale);
void drawHandles(std::span<const Handle> handles, int hot, const ViewDrawing& drawing,
                 const Theme& theme);

// Where on the line through `origin` along `axis` (entity space) the pointer's ray comes nearest,
// as the coordinate of that axis; nothing when it looks along the line.
[[nodiscard]] std::optional<double> alongAxis(const Camera::Ray& ray, glm::dvec3 origin, int axis);

}  // namespace voxprite::editor
