#include "app/editor/tools/laser_tool.h"

#include <array>

#include "app/editor/tools/brush_path.h"
#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"
#include "core/edit/voxel_changes.h"

namespace voxprite::editor {

LaserTool::Beam LaserTool::beamOf(const EditTarget& target, const ToolOptions& options) {
    // Round seen from everywhere.
    const TipShape shape = options.tip == TipShape::disc ? TipShape::sphere : options.tip;
    return {target, BrushTrail({shape, options.tipEdge, 2}), VoxelPatch{target.model(), {}}};
}

bool LaserTool::burn(Beam& beam, const ToolContext& context, std::span<const glm::dvec2> pathPx) {
    const Session& session = context.session;
    std::vector<glm::ivec3> fresh;
    alongPath(pathPx, [&](glm::dvec2 px) {
        const Camera::Ray ray = context.camera.rayThrough(px);
        bool starts = true;
        for (const glm::ivec3 voxel : voxelsAlongRay(
                 voxelFromWorld(ray.origin), voxelFromWorld(ray.direction), session.bounds())) {
            for (const glm::ivec3 reached :
                 starts ? beam.trail.startAt(voxel) : beam.trail.lineTo(voxel)) {
                fresh.push_back(beam.target.toModel(reached));
            }
            starts = false;
        }
    });
    const VoxelPatch more = beam.target.patch(session, fresh, EditMode::erase, context.settings);
    if (more.changes.empty()) return false;
    mergeChanges(beam.patch.changes, more.changes);
    return true;
}

ToolResult LaserTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    const std::array<glm::dvec2, 1> here{input.pointerPx};
    if (!beam_ && input.pressed && context.pick) {
        const Result<EditTarget> target =
            EditTarget::at(context.session, EditMode::erase, *context.pick);
        if (!target) {
            result.refusal = target.error().message;
            return result;
        }
        context.session.setActiveNode(target->node());
        beam_ = beamOf(*target, context.settings.options);
        static_cast<void>(burn(*beam_, context, here));
        result.preview = {beam_->patch};
    } else if (beam_ && burn(*beam_, context, input.pathPx)) {
        result.preview = {beam_->patch};
    }
    if (beam_) {
        if (input.released) result.action = confirm(context.session);
        return result;
    }
    const Aim aim = context.aim();
    if (shown_ == aim && shownPx_ == input.pointerPx) return result;
    shown_ = aim;
    shownPx_ = input.pointerPx;
    result.preview.emplace();
    if (!aim.pick) return result;
    if (const auto target = EditTarget::at(context.session, EditMode::erase, *aim.pick)) {
        Beam beam = beamOf(*target, context.settings.options);
        static_cast<void>(burn(beam, context, here));
        result.preview->push_back(std::move(beam.patch));
    }
    return result;
}

std::optional<Action> LaserTool::confirm(Session& /*session*/) {
    if (!beam_) return std::nullopt;
    std::optional<Action> action;
    if (!beam_->patch.changes.empty()) action = makeAction("Laser", std::move(beam_->patch));
    cancel();
    return action;
}

void LaserTool::cancel() {
    beam_.reset();
    shown_.reset();
}

void LaserTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                     const Theme& theme) const {
    if (!context.pick || context.pick->ground) return;
    markFace(drawing, theme, *context.pick, EditMode::erase);
    drawing.box(tipBox({TipShape::cube, context.settings.options.tipEdge, 2}, context.pick->voxel),
                withAlpha(theme.danger, 0.9f), theme.px(1.5f));
}

}  // namespace voxprite::editor
