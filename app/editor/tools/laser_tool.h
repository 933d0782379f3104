// The laser: erases everything along the eye's ray, as thick as the brush's tip, through the whole
// of the object that was hit.
#pragma once

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class LaserTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return beam_.has_value(); }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override;

  private:
    struct Beam {
        EditTarget target;
        BrushTrail trail;
        VoxelPatch patch;
    };
    [[nodiscard]] static Beam beamOf(const EditTarget& target, const ToolOptions& options);
    // Returns whether there is more to erase than before.
    [[nodiscard]] static bool burn(Beam& beam, const ToolContext& context,
                                   std::span<const glm::dvec2> pathPx);

    std::optional<Beam> beam_;
    std::optional<Aim> shown_;
    glm::dvec2 shownPx_{0.0};
};

}  // namespace voxprite::editor
