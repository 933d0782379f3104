// Where a brush goes when the pointer moves over a model: from pixels to voxels, without gaps.
#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/editor/tools/edit_target.h"

namespace voxprite::editor {

// Visits every pixel step of the path, its first point included.
void alongPath(std::span<const glm::dvec2> pathPx, const std::function<void(glm::dvec2 px)>& visit);

// The tip on the face that was hit: discs lie in it.
[[nodiscard]] BrushTip tipOn(const Pick& pick, const ToolOptions& options);
// The voxel that the tip is put down at. Spheres and discs have their middle on the voxel that is
// attached or hit, cubes stand on the face or bite in from it.
[[nodiscard]] glm::ivec3 tipPlace(const BrushTip& tip, const Pick& pick, EditMode mode);

// One stroke's way. Aimed at the document, which does not change before the stroke ends: so it
// attaches or erases one layer and never digs or climbs on what it just did.
class BrushPath {
  public:
    BrushPath(const EditTarget& target, EditMode mode, const ToolOptions& options)
        : target_(target), mode_(mode), options_(options) {}

    // The model-space voxels that the pointer newly reached.
    [[nodiscard]] std::vector<glm::ivec3> extend(const Session& session, const Camera& camera,
                                                 std::span<const glm::dvec2> pathPx);

  private:
    void step(const Session& session, const Pick& pick, std::vector<glm::ivec3>& fresh);

    EditTarget target_;
    EditMode mode_;
    ToolOptions options_;
    std::array<std::optional<BrushTrail>, 3> trails_;  // by the axis of the face
    std::optional<Pick> last_;
};

}  // namespace voxprite::editor
