// Holds the tool in hand, hands it the input of each frame, and carries out what it says: the
// preview at once, actions by whoever performs them.
#pragma once

#include <memory>

#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class ToolBox {
  public:
    struct Outcome {
        std::vector<Action> actions;
        std::string refusal;
    };
    // With `picksColour` (Alt) the left button picks a colour, whatever the tool.
    [[nodiscard]] Outcome update(const ToolContext& context, bool picksColour);
    void draw(const ToolContext& context, const ViewDrawing& drawing, const Theme& theme) const;

    // What is being made becomes an action: Enter, and before anything that needs the whole
    // document (saving, another edit).
    [[nodiscard]] std::optional<Action> confirm(Session& session);
    // It is dropped: Esc, undo.
    void cancel(Session& session);
    [[nodiscard]] bool busy() const { return tool_ && tool_->busy(); }
    // A coming edit of very many voxels is still being worked out.
    [[nodiscard]] bool previewsLater() const { return large_->working(); }
    void finishPreview(Session& session) { large_->finish(session); }
    [[nodiscard]] bool wantsWheel() const { return tool_ && tool_->wantsWheel(); }
    [[nodiscard]] Tool* tool() { return tool_.get(); }
    [[nodiscard]] const Tool* tool() const { return tool_.get(); }

  private:
    void take(ToolKind kind, Session& session, Outcome& outcome);

    std::unique_ptr<Tool> tool_;
    std::unique_ptr<LargePreview> large_ = std::make_unique<LargePreview>();
    ToolKind kind_ = ToolKind::brush;
    // Models go when adding them is undone, and with them what a tool was making of them.
    std::size_t models_ = 0;
    int frame_ = 0;  // in which the tool makes what it makes
    // Where the pointer was when something was done: until it moves on, the result is shown and not
    // what the next click would do on top of it.
    std::optional<glm::dvec2> restsPx_;
};

}  // namespace voxprite::editor
