// Puts sockets where the hand clicks: in the middle of a voxel, with Shift in the middle of its
// face. A socket that is there already is dragged over the model instead.
#pragma once

#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class SocketTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return dragged_.has_value(); }
    void cancel() override { dragged_.reset(); }

  private:
    std::optional<int> dragged_;  // index into Document::sockets
    std::uint64_t mergeKey_ = 0;
};

}  // namespace voxprite::editor
