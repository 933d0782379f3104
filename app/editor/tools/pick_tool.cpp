#include "app/editor/tools/pick_tool.h"

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {

ToolResult PickTool::update(const ToolContext& context) {
    ToolResult result;
    if (!context.input.pressed || !context.pick || context.pick->ground) return result;
    ToolSettings& settings = context.settings;
    const Pick& pick = *context.pick;
    if (settings.tool == ToolKind::pickColour) {
        settings.colour = context.session.octree().at(pick.voxel);
    } else {
        const Entity& before = context.session.document().entity;
        Entity after = before;
        // The voxel's middle; with Shift the middle of its face.
        glm::dvec3 anchor = glm::dvec3(pick.voxel) + 0.5;
        if (context.input.shift) anchor += glm::dvec3(pick.normal) * 0.5;
        after.anchorVoxels = anchor;
        result.action = makeAction("Set anchor", EntityEdit{before, after});
    }
    settings.tool = settings.before;
    return result;
}

void PickTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (!context.pick || context.pick->ground) return;
    const glm::ivec3 voxel = context.pick->voxel;
    markFace(drawing, theme, *context.pick, EditMode::paint);
    drawing.box(IBox::around(voxel, voxel), withAlpha(theme.accent, 0.9f), theme.px(1.5f));
}

}  // namespace voxprite::editor
