// The stamp: puts a copy of the clipboard on the face that is clicked.
#pragma once

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class StampTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    void cancel() override;

  private:
    [[nodiscard]] MakePatches patchesOf(const ToolContext& context, const EditTarget& target,
                                        const Pick& pick);

    std::optional<Aim> aim_;
    IBox box_;  // where it would go; entity space
};

}  // namespace voxprite::editor
