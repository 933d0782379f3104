#include "app/editor/tools/socket_tool.h"

#include "app/editor/tools/tool_marks.h"
#include "app/editor/views/socket_markers.h"
#include "core/edit/socket_edits.h"

namespace voxprite::editor {
namespace {

constexpr double kMarkReachPx = 9.0;  // of a mark, for the hand

std::optional<glm::dvec3> pointUnder(const ToolContext& context) {
    if (!context.pick || context.pick->ground) return std::nullopt;
    glm::dvec3 point = glm::dvec3(context.pick->voxel) + 0.5;
    if (context.input.shift) point += glm::dvec3(context.pick->normal) * 0.5;
    return point;
}

std::optional<int> markUnder(const ToolContext& context) {
    if (!context.input.hovered) return std::nullopt;
    return socketAt(context.session, context.camera, context.input.pointerPx,
                    kMarkReachPx * static_cast<double>(context.scale));
}

}  // namespace

ToolResult SocketTool::update(const ToolContext& context) {
    ToolResult result;
    const Document& document = context.session.document();
    const std::optional<glm::dvec3> point = pointUnder(context);
    if (context.input.pressed) {
        dragged_ = markUnder(context);
        mergeKey_ = context.session.newMergeKey();
        if (!dragged_ && point) result.action = addSocket(document, *point);
        return result;
    }
    if (!context.input.held || !dragged_) {
        dragged_.reset();
        return result;
    }
    if (!point || *dragged_ >= static_cast<int>(document.sockets.size())) return result;
    const int frame = context.session.frame();
    const Socket& socket = document.sockets[static_cast<std::size_t>(*dragged_)];
    if (positionAt(socket, frame) == *point) return result;
    const SocketReach reach =
        context.settings.socketsInThisFrame ? SocketReach::thisFrame : SocketReach::allFrames;
    result.action = moveSocket(document, *dragged_, frame, *point, reach, mergeKey_);
    return result;
}

void SocketTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                      const Theme& theme) const {
    if (dragged_ || markUnder(context)) return;
    const std::optional<glm::dvec3> point = pointUnder(context);
    if (!point) return;
    markFace(drawing, theme, *context.pick, EditMode::paint);
    const auto at = drawing.project(worldFromVoxel(*point));
    if (!at) return;
    drawing.list().AddCircleFilled(*at, theme.px(5), IM_COL32(16, 17, 19, 200));
    drawing.list().AddCircleFilled(*at, theme.px(3), theme.accent);
}

}  // namespace voxprite::editor
