#include "app/editor/tools/fill_tool.h"

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {
namespace {

// A region larger than this is only outlined before the click: to show it whole would make the
// pointer stick.
constexpr std::uint64_t kMostShown = 100'000;

}  // namespace

EditMode FillTool::modeOf(const ToolContext& context) const {
    const EditMode mode = context.mode();
    return kind_ == Kind::connected && mode == EditMode::attach ? EditMode::paint : mode;
}

Result<VoxelSet> FillTool::region(const ToolContext& context, const EditTarget& target,
                                  const Pick& pick) const {
    const VoxelGrid& voxels = target.voxels(context.session);
    const ToolOptions& options = context.settings.options;
    if (kind_ == Kind::connected) {
        return connectedRegion(voxels, target.toModel(pick.voxel), options.region());
    }
    const glm::ivec3 normal = target.directionToModel(pick.normal);
    if (context.mode() != EditMode::attach) {
        return faceRegion(voxels, target.toModel(pick.voxel), normal, options.region());
    }
    // Within the artist's limits, or else within the model.
    const glm::ivec3 seed = target.toModel(pick.attachTo());
    const IBox around = options.limited ? target.modelFromEntity().applyToBox(options.limits)
                                        : voxels.bounds().united(IBox::around(seed, seed));
    return planeRegion(voxels, seed, target.axisToModel(pick.axis()), around);
}

ToolResult FillTool::update(const ToolContext& context) {
    ToolResult result;
    const bool pressed = context.input.pressed && context.pick;
    if (pressed) {
        const EditMode mode = modeOf(context);
        const Result<EditTarget> target = EditTarget::at(context.session, mode, *context.pick);
        if (!target) {
            result.refusal = target.error().message;
            return result;
        }
        const bool isShown =
            shown_ && (aim_ == context.aim() || isStillOn(context.session, context.aim()));
        const Result<VoxelSet> filled = isShown ? Result<VoxelSet>(std::move(shown_->voxels))
                                                : region(context, *target, *context.pick);
        Result<VoxelPatch> patch =
            filled ? target->patch(context.session, *filled, mode, context.settings)
                   : Result<VoxelPatch>(Failure(filled.error()));
        cancel();
        if (!patch) {
            result.refusal = patch.error().message;
            return result;
        }
        context.session.setActiveNode(target->node());
        if (!patch->changes.empty()) {
            const char* label = mode == EditMode::erase    ? "Erase region"
                                : kind_ == Kind::connected ? "Fill"
                                                           : "Fill plane";
            result.action = makeAction(label, std::move(*patch));
        }
        return result;
    }
    show(context, result);
    return result;
}

bool FillTool::isStillOn(const Session& session, const Aim& aim) const {
    if (!shown_ || !aim_ || !aim_->pick || !aim.pick) return false;
    Aim elsewhere = aim;
    elsewhere.pick = aim_->pick;
    if (elsewhere != *aim_) return false;
    const bool fillsEmpty = kind_ == Kind::plane && aim.mode == EditMode::attach;
    if (kind_ == Kind::plane && aim.pick->normal != aim_->pick->normal) return false;
    if (!fillsEmpty && session.nodeAt(aim.pick->voxel) != shown_->node) return false;
    return shown_->voxels.contains(
        shown_->modelFromEntity.applyToVoxel(fillsEmpty ? aim.pick->attachTo() : aim.pick->voxel));
}

void FillTool::show(const ToolContext& context, ToolResult& result) {
    const Aim aim = context.aim();
    if (aim_ == aim) return;
    const bool same = isStillOn(context.session, aim);
    aim_ = aim;
    if (same) return;
    shown_.reset();
    result.preview.emplace();
    if (!aim.pick) return;
    const EditMode mode = modeOf(context);
    const Result<EditTarget> target = EditTarget::at(context.session, mode, *aim.pick);
    if (!target) return;
    Result<VoxelSet> filled = region(context, *target, *aim.pick);
    if (!filled) return;
    shown_ = Shown{target->node(), target->modelFromEntity(), std::move(*filled), {}};
    shown_->box = target->modelFromEntity().inverse().applyToBox(shown_->voxels.bounds());
    if (shown_->voxels.count() > kMostShown) return;
    if (auto patch = target->patch(context.session, shown_->voxels, mode, context.settings)) {
        result.preview->push_back(std::move(*patch));
    }
}

void FillTool::cancel() {
    aim_.reset();
    shown_.reset();
}

void FillTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (!context.pick || !shown_) return;
    const EditMode mode = modeOf(context);
    markFace(drawing, theme, *context.pick, mode);
    drawing.box(shown_->box, withAlpha(colourOf(theme, mode), 0.8f), theme.px(1.5f));
}

}  // namespace voxprite::editor
