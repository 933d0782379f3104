#include "app/editor/tools/fill_tool.h"

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {

EditMode FillTool::modeOf(const ToolContext& context) const {
    const EditMode mode = context.mode();
    return kind_ == Kind::connected && mode == EditMode::attach ? EditMode::paint : mode;
}

FillTool::Region FillTool::region(const ToolContext& context, const EditTarget& target,
                                  const Pick& pick) const {
    const ToolOptions& options = context.settings.options;
    const RegionRule rule = options.region();
    const glm::ivec3 hit = target.toModel(pick.voxel);
    if (kind_ == Kind::connected) {
        return [=](const VoxelGrid& voxels, std::size_t maxBlocks) {
            return connectedRegion(voxels, hit, rule, maxBlocks);
        };
    }
    const glm::ivec3 normal = target.directionToModel(pick.normal);
    if (context.mode() != EditMode::attach) {
        return [=](const VoxelGrid& voxels, std::size_t maxBlocks) {
            return faceRegion(voxels, hit, normal, rule, maxBlocks);
        };
    }
    // Within the artist's limits, or else within the model.
    const glm::ivec3 seed = target.toModel(pick.attachTo());
    const int axis = target.axisToModel(pick.axis());
    std::optional<IBox> limits;
    if (options.limited) limits = target.modelFromEntity().applyToBox(options.limits);
    return [=](const VoxelGrid& voxels, std::size_t maxBlocks) {
        const IBox around = limits ? *limits : voxels.bounds().united(IBox::around(seed, seed));
        return planeRegion(voxels, seed, axis, around, maxBlocks);
    };
}

Action FillTool::actionOf(const ToolContext& context, const EditTarget& target,
                          EditMode mode) const {
    return makeActionLater(mode == EditMode::erase    ? "Erase region"
                           : kind_ == Kind::connected ? "Fill"
                                                      : "Fill plane",
                           target.later(context.session, shown_->find(), mode, context.settings));
}

ToolResult FillTool::update(const ToolContext& context) {
    ToolResult result;
    show(context, result);
    if (shown_ && shown_->box.empty()) {
        if (const auto voxels = shown_->voxels->load()) {
            shown_->box = shown_->modelFromEntity.inverse().applyToBox(voxels->bounds());
        }
    }
    if (!context.input.pressed || !context.pick) return result;
    const EditMode mode = modeOf(context);
    const Result<EditTarget> target = EditTarget::at(context.session, mode, *context.pick);
    if (!target) {
        result.refusal = target.error().message;
        return result;
    }
    if (!shown_) return result;
    context.session.setActiveNode(target->node());
    Action action = actionOf(context, *target, mode);
    if (!shown_->isLarge) {
        const Status made = makeParts(action, context.session.document());
        if (!made) result.refusal = made.error().message;
        const auto* patch =
            action.parts.empty() ? nullptr : std::get_if<VoxelPatch>(&action.parts.front());
        if (patch == nullptr || patch->changes.empty()) return result;
    }
    cancel();
    result.action = std::move(action);
    return result;
}

bool FillTool::isStillOn(const Session& session, const Aim& aim) const {
    if (!shown_ || !aim_ || !aim_->pick || !aim.pick) return false;
    if (!aim_->differsInPickAlone(aim)) return false;
    const bool fillsEmpty = kind_ == Kind::plane && aim.mode == EditMode::attach;
    if (kind_ == Kind::plane && aim.pick->normal != aim_->pick->normal) return false;
    if (!fillsEmpty && session.nodeAt(aim.pick->voxel) != shown_->node) return false;
    const auto voxels = shown_->voxels->load();
    if (!voxels) return false;
    return voxels->contains(
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
    using Found = std::atomic<std::shared_ptr<const VoxelSet>>;
    shown_ = Shown{target->node(),
                   target->modelFromEntity(),
                   region(context, *target, *aim.pick),
                   std::make_shared<Found>(),
                   {},
                   false};
    if (Result<VoxelSet> quick =
            shown_->region(target->voxels(context.session), kQuickRegionBlocks)) {
        shown_->isLarge = quick->count() > kLongStepVoxels;
        shown_->voxels->store(std::make_shared<const VoxelSet>(std::move(*quick)));
    } else {
        shown_->isLarge = true;
    }
    const MakePatches make = target->later(context.session, shown_->find(), mode, context.settings);
    if (shown_->isLarge) {
        result.largePreview = [make](const Session&) { return make; };
    } else if (auto patches = make(context.session.document())) {
        result.preview = std::move(*patches);
    }
}

EditTarget::FindVoxels FillTool::Shown::find() const {
    return [found = voxels, look = region](const VoxelGrid& model) -> Result<VoxelSet> {
        if (const auto known = found->load()) return *known;
        Result<VoxelSet> whole = look(model, kMaxRegionBlocks);
        if (whole) found->store(std::make_shared<const VoxelSet>(*whole));
        return whole;
    };
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
    if (shown_->box.empty()) return;
    drawing.box(shown_->box, withAlpha(colourOf(theme, mode), 0.8f), theme.px(1.5f));
}

}  // namespace voxprite::editor
