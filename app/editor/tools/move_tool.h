// Moves what is selected, or the whole object while nothing is: by dragging its voxels across the
// face that was grabbed, by the arrows of three axes, or by figures. What it lifted floats until it
// is put down by Enter, by a click beside it or by taking another tool. What other commands put
// into the air (pasted, turned, hollowed out) is shown and put down here, too.
#pragma once

#include <array>
#include <utility>

#include "app/editor/tools/handles.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class MoveTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    // What was cancelled is gone, though that has not been looked at yet.
    [[nodiscard]] bool busy() const override { return floats_ && seen_; }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override;
    [[nodiscard]] std::vector<ToolFigure> figures() const override;
    void setFigure(std::size_t index, int value) override { typed_ = {index, value}; }
    [[nodiscard]] std::string sizeText() const override;

  private:
    struct Drag {
        int axis = 0;  // along it; or, with `plane`, across it
        bool plane = false;
        double facePlane = 0.0;
        glm::dvec3 grabbed{0.0};
        glm::ivec3 min{0};  // of the bounds, then
    };
    // All that the picture depends on.
    struct Seen {
        std::uint64_t selection = 0, session = 0;
        int node = -1;
        bool operator==(const Seen&) const = default;
    };
    void press(const ToolContext& context, ToolResult& result);
    void drag(const ToolContext& context);
    void look(const ToolContext& context, ToolResult& result);
    [[nodiscard]] std::array<Handle, 3> arrows(const Camera& camera, float scale) const;
    [[nodiscard]] bool holds(const Session& session, glm::ivec3 entityVoxel) const;

    bool floats_ = false;
    Floating::Kind kind_ = Floating::Kind::move;
    int amount_ = 1;
    glm::ivec3 moved_{0};
    IBox box_;            // of what is moved, or would be; entity space
    VoxelGrid floating_;  // what floats, as it lies in entity space
    std::optional<Seen> seen_;
    std::optional<Drag> drag_;
    std::optional<std::pair<std::size_t, int>> typed_;
    int hot_ = -1;
};

}  // namespace voxprite::editor
