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
        const Result<VoxelSet> filled = region(context, *target, *context.pick);
        Result<VoxelPatch> patch =
            filled ? target->patch(context.session, *filled, mode, context.settings)
                   : Result<VoxelPatch>(Failure(filled.error()));
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
        cancel();
        return result;
    }
    show(context, result);
    return result;
}

void FillTool::show(const ToolContext& context, ToolResult& result) {
    const Aim aim = context.aim();
    if (aim_ == aim) return;
    aim_ = aim;
    regionBox_ = {};
    result.preview.emplace();
    if (!aim.pick) return;
    const EditMode mode = modeOf(context);
    const Result<EditTarget> target = EditTarget::at(context.session, mode, *aim.pick);
    if (!target) return;
    const Result<VoxelSet> filled = region(context, *target, *aim.pick);
    if (!filled) return;
    regionBox_ = target->modelFromEntity().inverse().applyToBox(filled->bounds());
    if (filled->count() > kMostShown) return;
    if (auto patch = target->patch(context.session, *filled, mode, context.settings)) {
        result.preview->push_back(std::move(*patch));
    }
}

void FillTool::cancel() {
    aim_.reset();
    regionBox_ = {};
}

void FillTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (!context.pick || regionBox_.empty()) return;
    const EditMode mode = modeOf(context);
    markFace(drawing, theme, *context.pick, mode);
    drawing.box(regionBox_, withAlpha(colourOf(theme, mode), 0.8f), theme.px(1.5f));
}

}  // namespace voxprite::editor
