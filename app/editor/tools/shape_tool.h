// Box, line, sphere, ellipsoid and cylinder. Dragging spans one over the face that was pressed (the
// wheel gives it depth); its handles and figures then change it until it is confirmed by Enter, by
// starting the next one or by taking another tool.
#pragma once

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/handles.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class ShapeTool final : public Tool {
  public:
    explicit ShapeTool(ToolKind kind) : kind_(kind) {}

    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return shape_.has_value(); }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override;
    [[nodiscard]] bool wantsWheel() const override { return shape_ && shape_->spanning; }
    [[nodiscard]] std::vector<ToolFigure> figures() const override;
    void setFigure(std::size_t index, int value) override;
    [[nodiscard]] std::string sizeText() const override;

  private:
    struct Pending {
        EditTarget target;
        EditMode mode = EditMode::attach;
        EditMode chosenMode = EditMode::attach;  // in the options when `mode` was settled
        Pick start;
        // Two opposite corner voxels, or the ends of a line; entity space. The first stays.
        glm::ivec3 first{0}, last{0};
        glm::ivec3 grows{1};    // the way the size of each axis grows, seen from `first`
        bool spanning = true;   // the button that began it is still down
        bool deepened = false;  // the depth is the artist's and no longer the tool's
        int handle = -1;        // being dragged

        [[nodiscard]] IBox box() const { return IBox::around(first, last); }
    };
    // All that its voxels depend on.
    struct Made {
        glm::ivec3 first{0}, last{0};
        EditMode mode = EditMode::attach;
        ToolSettings settings;
        std::uint64_t revision = 0;
        bool operator==(const Made&) const = default;
    };

    void begin(const ToolContext& context, const Pick& pick, ToolResult& result);
    void span(const ToolContext& context);
    void spanLine(const ToolContext& context);
    void deepen(int layers);
    void dragHandle(const ToolContext& context);
    // One edge was given: a sphere keeps its others the same.
    void resize(int axis, int edge);
    void makeRegular(int edge);
    void make(const ToolContext& context, ToolResult& result);
    void showHover(const ToolContext& context, ToolResult& result);
    // In model space, whatever the model.
    [[nodiscard]] EditTarget::FindVoxels voxels(const ToolOptions& options) const;
    [[nodiscard]] bool isLarge() const;
    [[nodiscard]] std::vector<Handle> handles() const;
    [[nodiscard]] const char* noun() const;

    ToolKind kind_;
    std::optional<Pending> shape_;
    VoxelPatch patch_;   // what shape_ makes of the document
    MakePatches later_;  // the same when it is of very many voxels
    std::optional<Made> made_;
    std::optional<Aim> hovered_;
    int hot_ = -1;             // the handle under the pointer
    bool startsNext_ = false;  // the press that confirmed the last one begins another
};

}  // namespace voxprite::editor
