#include "app/editor/tools/stamp_tool.h"

#include "app/editor/session/selection_edits.h"
#include "app/editor/tools/tool_marks.h"
#include "core/edit/clip.h"
#include "core/edit/make_action.h"
#include "core/edit/transforms.h"
#include "core/edit/voxel_changes.h"

namespace voxprite::editor {
namespace {

// Where a box of this size stands on a face: in the middle of it, touching.
IBox standOn(glm::ivec3 size, const Pick& pick) {
    const int axis = pick.axis();
    glm::ivec3 min = pick.attachTo() - (size - 1) / 2;
    min[axis] =
        pick.normal[axis] > 0 ? pick.attachTo()[axis] : pick.attachTo()[axis] - size[axis] + 1;
    return {min, min + size};
}

}  // namespace

MakePatches StampTool::patchesOf(const ToolContext& context, const EditTarget& target,
                                 const Pick& pick) {
    // As it looks on screen, whichever way the object was turned that it came from or goes to.
    const auto clip = context.session.clip();
    const IBox lies = clip->bounds();
    box_ = standOn(lies.size(), pick);
    const Placement modelFromClip =
        target.modelFromEntity() * translation(box_.min - lies.min) * clip->modelFromClip;
    const ToolOptions& options = context.settings.options;
    const std::optional<IBox> limits =
        target.limits(context.session, EditMode::attach, options).box;
    return [clip, modelFromClip, limits, images = imagesOf(target.symmetry(options)),
            model = target.model()](const Document& document) -> Result<std::vector<VoxelPatch>> {
        VoxelPatch all{model, {}};
        VoxelClip mirroredClip = *clip;
        for (const Placement& image : images) {
            mirroredClip.modelFromClip = image * modelFromClip;
            Result<VoxelPatch> patch =
                patchPaste(document, model, mirroredClip, PasteRule::over, {limits, nullptr});
            if (!patch) return Failure(patch.error());
            mergeChanges(all.changes, patch->changes);
        }
        return onePatch(std::move(all));
    };
}

ToolResult StampTool::update(const ToolContext& context) {
    ToolResult result;
    const bool pressed = context.input.pressed && context.pick;
    const Aim aim = context.aim();
    if (!pressed && aim_ == aim) return result;
    aim_ = aim;
    box_ = {};
    if (!context.session.clip()) {
        result.preview.emplace();
        if (pressed) result.refusal = "Copy a selection first: Ctrl+C";
        return result;
    }
    if (!clipFits(context.session)) {
        result.preview.emplace();
        if (pressed) result.refusal = "This was copied under another palette: paste it once first";
        return result;
    }
    if (!pressed) result.preview.emplace();
    if (!aim.pick) return result;
    const Result<EditTarget> target = EditTarget::at(context.session, EditMode::attach, *aim.pick);
    if (!target) {
        if (pressed) result.refusal = target.error().message;
        return result;
    }
    const MakePatches make = patchesOf(context, *target, *aim.pick);
    if (context.session.clip()->voxels.solidCount() > kLongStepVoxels) {
        if (pressed) {
            result.action = makeActionLater("Stamp", make);
            cancel();
        } else {
            result.largePreview = [make](const Session&) { return make; };
        }
        return result;
    }
    Result<std::vector<VoxelPatch>> patches = make(context.session.document());
    if (!patches) {
        if (pressed) result.refusal = patches.error().message;
        return result;
    }
    if (!pressed) {
        result.preview = std::move(*patches);
    } else if (!patches->front().changes.empty()) {
        result.action = makeAction("Stamp", std::move(patches->front()));
        cancel();
    }
    return result;
}

void StampTool::cancel() {
    aim_.reset();
    box_ = {};
}

void StampTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                     const Theme& theme) const {
    if (context.pick && !box_.empty()) drawing.box(box_, theme.accent, theme.px(1.5f));
}

}  // namespace voxprite::editor
