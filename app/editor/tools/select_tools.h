// The tools that select: a box, a rectangle on screen, the magic wand. Shift adds, Shift+Alt takes
// away; a click beside the model selects nothing. They change what is selected and no voxel.
#pragma once

#include "app/editor/tools/handles.h"
#include "app/editor/tools/tool.h"
#include "core/edit/selection.h"

namespace voxprite::editor {

[[nodiscard]] SelectMode selectModeOf(const ToolInput& input);

// Dragged from one voxel to another, then resized by its handles or figures until something else
// is selected or the object lies elsewhere.
class SelectBoxTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return box_ && box_->handle != kSettled; }
    [[nodiscard]] std::optional<Action> confirm(Session& session) override;
    void cancel() override { box_.reset(); }
    [[nodiscard]] std::vector<ToolFigure> figures() const override;
    void setFigure(std::size_t index, int value) override;
    [[nodiscard]] std::string sizeText() const override;

  private:
    static constexpr int kSettled = -1, kSpanning = -2;
    struct Spanned {
        int node = -1, model = 0;
        Placement modelFromEntity;
        glm::ivec3 first{0};
        IBox box;  // entity space
        SelectMode mode = SelectMode::replace;
        VoxelSet before;             // what was selected in this object
        int handle = kSpanning;      // the one that is dragged
        bool onGround = false;       // it began beside the model
        IBox selected;               // the box that has been selected
        std::uint64_t revision = 0;  // of the selection that it made
    };
    [[nodiscard]] bool holds(const Session& session) const;
    void begin(const ToolContext& context, ToolResult& result);
    void dragHandle(const ToolContext& context);
    void select(Session& session);
    [[nodiscard]] std::vector<Handle> handles() const;

    std::optional<Spanned> box_;
    int hot_ = -1;
};

class SelectRectangleTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    [[nodiscard]] bool busy() const override { return start_.has_value(); }
    void cancel() override { start_.reset(); }

  private:
    struct Start {
        glm::dvec2 px{0.0};
        SelectMode mode = SelectMode::replace;
    };
    std::optional<Start> start_;
    glm::dvec2 endPx_{0.0};
};

class WandTool final : public Tool {
  public:
    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;

    // Around what a click would take, entity space; empty where there is nothing, and where it is
    // so much that the pointer would have to wait for it.
    [[nodiscard]] IBox shownBox() const { return shown_ ? shown_->box : IBox{}; }

  private:
    // Is the pointer on another voxel of the region that is shown, and nothing else new?
    [[nodiscard]] bool isStillOn(const Session& session, const Aim& aim) const;
    void look(const ToolContext& context);

    // The region under the pointer.
    struct Shown {
        int node = -1;
        Placement modelFromEntity;
        VoxelSet voxels;  // model space
        IBox box;         // around them, entity space
    };

    std::optional<Aim> aim_;
    std::optional<Shown> shown_;
};

}  // namespace voxprite::editor
