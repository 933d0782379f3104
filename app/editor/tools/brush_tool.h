// The brush: attaches, erases or paints what its tip is drawn over; nothing is done before the
// button is released, only shown.
#pragma once

#include "app/editor/tools/brush_path.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class BrushTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return stroke_.has_value(); }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override;

  private:
    struct Stroke {
        EditMode mode;
        EditTarget target;
        BrushPath path;
        VoxelPatch patch;
    };
    void begin(const ToolContext& context, ToolResult& result);
    void extend(const ToolContext& context, std::span<const glm::dvec2> pathPx, ToolResult& result);

    std::optional<Stroke> stroke_;
    std::optional<Aim> shown_;
};

}  // namespace voxprite::editor
