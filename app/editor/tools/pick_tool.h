// Tools for one click on a voxel: its colour into the hand, or the anchor onto it. Then the tool
// used before is taken up again.
#pragma once

#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class PickTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
};

}  // namespace voxprite::editor
