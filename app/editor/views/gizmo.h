// Handles on the proxy box in the sprite view: arrows that move it, rings that turn it (each one of
// its three angles), corners that scale it. Turns a drag into the entity it asks for.
#pragma once

#include <optional>

#include "app/editor/settings/settings.h"
#include "app/editor/views/view_drawing.h"
#include "core/model/document.h"
#include "core/sprite/placed_entity.h"

namespace voxprite::editor {

// What is needed to place the handles.
struct GizmoTarget {
    GizmoKind kind = GizmoKind::none;
    Entity entity;
    PlacedEntity placed;
    double sigmaInForce = 1.0;  // of the proxy box's margin
    double voxelMetres = 0.1;   // what moving snaps to
};

class Gizmo {
  public:
    // The entity that the drag makes, when it changed; a click on a handle makes none. Holding Ctrl
    // snaps: to voxels, 15 degrees, tenths.
    [[nodiscard]] std::optional<Entity> update(const GizmoTarget& target, const Camera& camera,
                                               const ViewInput& input, float uiScale, bool snap);
    void draw(const GizmoTarget& target, const Camera& camera, const ViewDrawing& drawing,
              const Theme& theme) const;
    // The pointer is on a handle, or drags one.
    [[nodiscard]] bool engaged() const { return hovered_ >= 0 || drag_.has_value(); }
    [[nodiscard]] bool dragging() const { return drag_.has_value(); }

  private:
    struct Drag {
        GizmoKind kind = GizmoKind::none;  // whose handle it is
        int handle = 0;
        glm::dvec2 pressPx{0.0};
        Entity before;
        PlacedEntity placedBefore;
        double startAngle = 0.0;
        glm::dvec3 start{0.0};  // world point under the press, on the handle's axis or plane
        bool left = false;      // the pointer has left the place of the press
    };
    [[nodiscard]] Entity moved(const GizmoTarget& target, const Camera& camera, glm::dvec2 px,
                               bool snap) const;
    [[nodiscard]] Entity turned(const Camera& camera, glm::dvec2 px, bool snap) const;
    [[nodiscard]] Entity scaled(const Camera& camera, glm::dvec2 px, bool snap) const;

    int hovered_ = -1;
    double armMetres_ = 1.0;  // length of an arrow, radius of a ring
    std::optional<Drag> drag_;
};

}  // namespace voxprite::editor
