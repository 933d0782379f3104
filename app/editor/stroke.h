// One stroke of a voxel tool, from the press of the button to its release: input in, actions out.
// A stroke is aimed at the model as it was when it began, so that dragging attaches or erases one
// layer and never digs or climbs on what it just did.
#pragma once

#include <optional>
#include <span>

#include "app/editor/picking.h"
#include "app/editor/session.h"
#include "core/edit/patches.h"

namespace voxprite::editor {

enum class BrushShape : std::uint8_t { voxel, box };

struct Brush {
    EditMode mode = EditMode::attach;
    BrushShape shape = BrushShape::voxel;
    std::uint8_t colour = 1;  // palette index
};

class Stroke {
  public:
    // Fails when nothing can be edited there: no object, or a hidden or locked one. Attaching goes
    // to the active object, erasing and painting to the object that was hit.
    [[nodiscard]] static Result<Stroke> begin(Session& session, const Brush& brush,
                                              const Pick& start);

    // The pointer went along `pathPx`, from its first point to its last; a fast hand leaves few of
    // them. With single voxels: what all of it changes.
    [[nodiscard]] std::optional<Action> drag(const Session& session, const Camera& camera,
                                             std::span<const glm::dvec2> pathPx);
    // Boxes only: one layer more or less, seen from the face.
    void deepen(int layers);
    // The button was released: what a box changes.
    [[nodiscard]] std::optional<Action> finish(const Session& session) const;

    // The box so far, entity space; nothing for single voxels.
    [[nodiscard]] std::optional<IBox> box() const;
    [[nodiscard]] const Brush& brush() const { return brush_; }

  private:
    Stroke(const Session& session, const Brush& brush, const Pick& start, Instance target);
    [[nodiscard]] glm::ivec3 cellOf(const Pick& pick) const;
    void stretchBox(const Camera::Ray& ray);
    // The model-space position to edit under a ray, if there is one.
    [[nodiscard]] std::optional<glm::ivec3> target(const Session& session,
                                                   const Camera::Ray& ray) const;
    [[nodiscard]] Action actionOf(VoxelPatch patch) const;

    Brush brush_;
    Pick start_;
    Instance target_;
    std::uint64_t mergeKey_ = 0;
    LiveOctree octree_;  // as it was
    IBox bounds_;
    glm::ivec3 corner_{0};  // opposite to the start; in the same layer
    int depth_ = 1;
};

}  // namespace voxprite::editor
