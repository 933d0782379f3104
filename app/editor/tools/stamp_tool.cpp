#include "app/editor/tools/stamp_tool.h"

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

Result<VoxelPatch> StampTool::patchOf(const ToolContext& context, const EditTarget& target,
                                      const Pick& pick) {
    // As it looks on screen, whichever way the object was turned that it came from or goes to.
    VoxelClip clip = *context.session.clip();
    const IBox lies = clip.bounds();
    box_ = standOn(lies.size(), pick);
    moveBy(clip, box_.min - lies.min);
    clip.modelFromClip = target.modelFromEntity() * clip.modelFromClip;

    const ToolOptions& options = context.settings.options;
    VoxelPatch all{target.model(), {}};
    for (const Placement& image : imagesOf(target.symmetry(options))) {
        VoxelClip mirroredClip = clip;
        mirroredClip.modelFromClip = image * clip.modelFromClip;
        Result<VoxelPatch> patch =
            patchPaste(context.session.document(), target.model(), mirroredClip, PasteRule::over,
                       target.limits(context.session, EditMode::attach, options));
        if (!patch) return patch;
        mergeChanges(all.changes, patch->changes);
    }
    return all;
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
    if (!pressed) result.preview.emplace();
    if (!aim.pick) return result;
    const Result<EditTarget> target = EditTarget::at(context.session, EditMode::attach, *aim.pick);
    Result<VoxelPatch> patch =
        target ? patchOf(context, *target, *aim.pick) : Result<VoxelPatch>(Failure(target.error()));
    if (!patch) {
        if (pressed) result.refusal = patch.error().message;
        return result;
    }
    if (!pressed) {
        result.preview->push_back(std::move(*patch));
    } else if (!patch->changes.empty()) {
        result.action = makeAction("Stamp", std::move(*patch));
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
