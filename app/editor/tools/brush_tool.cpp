#include "app/editor/tools/brush_tool.h"

#include <array>

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"
#include "core/edit/voxel_changes.h"

namespace voxprite::editor {

ToolResult BrushTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    if (!stroke_ && input.pressed && context.pick) begin(context, result);
    if (stroke_) {
        if (!input.pressed) extend(context, input.pathPx, result);
        if (input.released) {
            result.action = confirm(context.session);
        }
        return result;
    }
    const Aim aim = context.aim();
    if (shown_ == aim) return result;
    shown_ = aim;
    result.preview.emplace();
    if (!aim.pick) return result;
    const Result<EditTarget> target = EditTarget::at(context.session, aim.mode, *aim.pick);
    if (!target) return result;
    BrushPath path(*target, aim.mode, context.settings.options);
    const std::array<glm::dvec2, 1> here{input.pointerPx};
    const auto voxels = path.extend(context.session, context.camera, here);
    result.preview->push_back(target->patch(context.session, voxels, aim.mode, context.settings));
    return result;
}

void BrushTool::begin(const ToolContext& context, ToolResult& result) {
    const EditMode mode = context.mode();
    const Result<EditTarget> target = EditTarget::at(context.session, mode, *context.pick);
    if (!target) {
        result.refusal = target.error().message;
        return;
    }
    context.session.setActiveNode(target->node());
    stroke_ = Stroke{mode, *target, BrushPath(*target, mode, context.settings.options),
                     VoxelPatch{target->model(), {}}};
    const std::array<glm::dvec2, 1> here{context.input.pointerPx};
    extend(context, here, result);
    // Also when it changes nothing: what hovering showed is over.
    result.preview = {stroke_->patch};
    shown_.reset();
}

void BrushTool::extend(const ToolContext& context, std::span<const glm::dvec2> pathPx,
                       ToolResult& result) {
    const auto fresh = stroke_->path.extend(context.session, context.camera, pathPx);
    if (fresh.empty()) return;
    const VoxelPatch more =
        stroke_->target.patch(context.session, fresh, stroke_->mode, context.settings);
    if (more.changes.empty()) return;
    mergeChanges(stroke_->patch.changes, more.changes);
    result.preview = {stroke_->patch};
}

std::optional<Action> BrushTool::confirm(Session& /*session*/) {
    if (!stroke_) return std::nullopt;
    std::optional<Action> action;
    if (!stroke_->patch.changes.empty()) {
        action = makeAction(labelOf(stroke_->mode), std::move(stroke_->patch));
    }
    cancel();
    return action;
}

void BrushTool::cancel() {
    stroke_.reset();
    shown_.reset();
}

void BrushTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                     const Theme& theme) const {
    if (!context.pick) return;
    const EditMode mode = stroke_ ? stroke_->mode : context.mode();
    if (mode != EditMode::attach && context.pick->ground) return;
    const BrushTip tip = tipOn(*context.pick, context.settings.options);
    const IBox box = tipBox(tip, tipPlace(tip, *context.pick, mode));
    markFace(drawing, theme, *context.pick, mode);
    drawing.box(box, withAlpha(colourOf(theme, mode), 0.9f), theme.px(1.5f));
}

}  // namespace voxprite::editor
