// Pulls a face of the model out or pushes it in: drag, or click for one layer; the arrow, the
// figure and further drags change it until it is confirmed. In paint mode a click recolours the
// face.
#pragma once

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/handles.h"
#include "app/editor/tools/tool.h"
#include "core/edit/faces.h"

namespace voxprite::editor {

class FaceTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return pulled_.has_value(); }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override;
    [[nodiscard]] std::vector<ToolFigure> figures() const override;
    void setFigure(std::size_t index, int value) override;
    [[nodiscard]] std::string sizeText() const override;

  private:
    // A face of one object.
    struct Face {
        EditTarget target;
        Pick pick;                   // where it was found
        VoxelSet voxels;             // model space
        glm::ivec3 normal{0, 0, 1};  // model space
        IBox box;                    // of its voxels, entity space
    };
    struct Pulled {
        Face face;
        EditMode mode = EditMode::attach;
        int layers = 0;
        bool dragging = true;
        bool moved = false;
        double grabbed = 0.0;  // where along the axis the drag began, and with how many layers
        int layersBefore = 0;
    };

    [[nodiscard]] static Result<Face> faceAt(const ToolContext& context, EditMode mode,
                                             const Pick& pick);
    [[nodiscard]] Result<VoxelPatch> patchOf(const ToolContext& context, const Face& face,
                                             EditMode mode, int layers) const;
    void showHover(const ToolContext& context, ToolResult& result);
    void begin(const ToolContext& context, ToolResult& result);
    void drag(const ToolContext& context);
    void make(const ToolContext& context, ToolResult& result);
    [[nodiscard]] Handle arrow() const;

    std::optional<Pulled> pulled_;
    VoxelPatch patch_;
    std::optional<Aim> made_;  // with pulled_'s layers as they were then
    int madeLayers_ = 0;

    std::optional<Face> hovered_;
    std::optional<Aim> aim_;
    bool startsNext_ = false;
    bool hot_ = false;
};

}  // namespace voxprite::editor
