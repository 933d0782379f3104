#include "app/editor/tools/tool_box.h"

#include <glm/geometric.hpp>
#include <utility>

#include "app/editor/tools/brush_tool.h"
#include "app/editor/tools/face_tool.h"
#include "app/editor/tools/fill_tool.h"
#include "app/editor/tools/laser_tool.h"
#include "app/editor/tools/move_tool.h"
#include "app/editor/tools/pick_tool.h"
#include "app/editor/tools/select_tools.h"
#include "app/editor/tools/shape_tool.h"
#include "app/editor/tools/socket_tool.h"
#include "app/editor/tools/stamp_tool.h"

namespace voxprite::editor {
namespace {

constexpr double kRestPx = 4.0;

std::unique_ptr<Tool> makeTool(ToolKind kind) {
    switch (kind) {
        case ToolKind::brush:
            return std::make_unique<BrushTool>();
        case ToolKind::face:
            return std::make_unique<FaceTool>();
        case ToolKind::laser:
            return std::make_unique<LaserTool>();
        case ToolKind::fill:
            return std::make_unique<FillTool>(FillTool::Kind::connected);
        case ToolKind::planeFill:
            return std::make_unique<FillTool>(FillTool::Kind::plane);
        case ToolKind::stamp:
            return std::make_unique<StampTool>();
        case ToolKind::box:
        case ToolKind::line:
        case ToolKind::sphere:
        case ToolKind::ellipse:
        case ToolKind::cylinder:
            return std::make_unique<ShapeTool>(kind);
        case ToolKind::pickColour:
        case ToolKind::anchor:
            return std::make_unique<PickTool>();
        case ToolKind::socket:
            return std::make_unique<SocketTool>();
        case ToolKind::selectBox:
            return std::make_unique<SelectBoxTool>();
        case ToolKind::selectRectangle:
            return std::make_unique<SelectRectangleTool>();
        case ToolKind::wand:
            return std::make_unique<WandTool>();
        case ToolKind::move:
            return std::make_unique<MoveTool>();
    }
    return nullptr;
}

}  // namespace

void ToolBox::take(ToolKind kind, Session& session, Outcome& outcome) {
    if (tool_) {
        if (auto action = tool_->confirm(session)) outcome.actions.push_back(std::move(*action));
    }
    large_->drop();
    session.clearPreview();
    tool_ = makeTool(kind);
    kind_ = kind;
    restsPx_.reset();
}

ToolBox::Outcome ToolBox::update(const ToolContext& context, bool picksColour) {
    Outcome outcome;
    Session& session = context.session;
    const ToolInput& input = context.input;
    const std::size_t models = session.document().models.size();
    if (std::exchange(models_, models) > models) cancel(session);
    const bool otherFrame = std::exchange(frame_, session.frame()) != session.frame();
    if (tool_ && otherFrame) {
        // It comes down in the frame that it was begun in.
        if (auto action = tool_->confirm(session)) outcome.actions.push_back(std::move(*action));
    }
    if (!tool_ || kind_ != context.settings.tool) take(context.settings.tool, session, outcome);
    if (!tool_) return outcome;
    // Shift and Alt together take away from the selection.
    const bool selects = ToolSettings::isForSelection(kind_) && input.shift;
    picksColour = picksColour && !selects;
    if (picksColour && input.pressed && context.pick && !context.pick->ground) {
        context.settings.colour = session.octree().at(context.pick->voxel);
    }

    if (restsPx_) {
        const double moved = glm::length(input.pointerPx - *restsPx_);
        if (input.held || moved > kRestPx * static_cast<double>(context.scale)) restsPx_.reset();
    }
    ToolInput seen = input;
    const bool aims = !picksColour || tool_->busy();
    if (!aims) seen.pressed = seen.hovered = false;
    const ToolContext given{session,
                            context.settings,
                            context.camera,
                            seen,
                            aims && !restsPx_ ? context.pick : std::nullopt,
                            context.scale};
    ToolResult result = tool_->update(given);
    outcome.refusal = std::move(result.refusal);
    if (result.preview) {
        large_->drop();
        if (const Status shown = session.preview(*result.preview); !shown) {
            outcome.refusal = shown.error().message;
        }
    }
    if (result.largePreview) {
        // Of the document as it is: of another one the tool asks anew.
        large_->ask([plan = std::move(result.largePreview),
                     revision = session.revision()](const Session& now) -> MakePatches {
            if (now.revision() != revision) return {};
            return plan(now);
        });
    }
    if (result.action) {
        large_->drop();
        outcome.actions.push_back(std::move(*result.action));
        restsPx_ = input.pointerPx;
    }
    large_->update(session);
    if (const auto problem = large_->takeProblem()) outcome.refusal = problem->message;
    return outcome;
}

void ToolBox::draw(const ToolContext& context, const ViewDrawing& drawing,
                   const Theme& theme) const {
    if (tool_ && !(restsPx_ && !tool_->busy())) tool_->draw(context, drawing, theme);
}

std::optional<Action> ToolBox::confirm(Session& session) {
    return tool_ ? tool_->confirm(session) : std::nullopt;
}

void ToolBox::cancel(Session& session) {
    if (tool_) tool_->cancel();
    large_->drop();
    session.selection().setFloating(std::nullopt);
    session.clearPreview();
}

}  // namespace voxprite::editor
