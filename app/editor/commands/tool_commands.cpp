#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

template <EditMode mode>
constexpr Command modeCommand(Command command) {
    command.menu = MenuId::tool;
    command.run = [](CommandContext& c) { c.settings.tool.chooseMode(mode); };
    command.on = [](const CommandContext& c) { return c.settings.tool.mode == mode; };
    return command;
}

constexpr const char* groupOf(ToolKind tool) {
    switch (tool) {
        case ToolKind::brush:
        case ToolKind::face:
        case ToolKind::laser:
        case ToolKind::fill:
        case ToolKind::planeFill:
        case ToolKind::stamp:
            return "Draw";
        case ToolKind::box:
        case ToolKind::line:
        case ToolKind::sphere:
        case ToolKind::ellipse:
        case ToolKind::cylinder:
            return "Shapes";
        case ToolKind::move:
        case ToolKind::selectBox:
        case ToolKind::selectRectangle:
        case ToolKind::wand:
            return "Select";
        case ToolKind::pickColour:
        case ToolKind::anchor:
        case ToolKind::socket:
            return "Pick and place";
    }
    return "";
}

template <ToolKind tool>
constexpr Command toolCommand(Command command) {
    command.menu = MenuId::tool;
    command.group = groupOf(tool);
    command.run = [](CommandContext& c) { c.settings.tool.choose(tool); };
    command.on = [](const CommandContext& c) { return c.settings.tool.tool == tool; };
    return command;
}

// Chosen again it puts the handles away.
template <GizmoKind kind>
constexpr Command gizmoCommand(Command command) {
    command.menu = MenuId::tool;
    command.group = "Proxy box";
    command.run = [](CommandContext& c) {
        GizmoKind& gizmo = c.settings.tool.gizmo;
        gizmo = gizmo == kind ? GizmoKind::none : kind;
    };
    command.on = [](const CommandContext& c) { return c.settings.tool.gizmo == kind; };
    return command;
}

}  // namespace

std::span<const Command> toolCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        modeCommand<EditMode::attach>({.id = modeAttach,
                                       .tag = "attach",
                                       .name = "Attach",
                                       .icon = icon::kAttach,
                                       .chords = {key(GLFW_KEY_T)}}),
        modeCommand<EditMode::erase>({.id = modeErase,
                                      .tag = "erase",
                                      .name = "Erase",
                                      .icon = icon::kErase,
                                      .chords = {key(GLFW_KEY_R)}}),
        modeCommand<EditMode::paint>({.id = modePaint,
                                      .tag = "paint",
                                      .name = "Paint",
                                      .icon = icon::kPaint,
                                      .chords = {key(GLFW_KEY_G)}}),

        toolCommand<ToolKind::brush>({.id = toolBrush,
                                      .tag = "brush",
                                      .name = "Brush",
                                      .icon = icon::kBrush,
                                      .chords = {key(GLFW_KEY_B)},
                                      .separator = true}),
        toolCommand<ToolKind::face>({.id = toolFace,
                                     .tag = "face",
                                     .name = "Extrude faces",
                                     .icon = icon::kFace,
                                     .chords = {key(GLFW_KEY_F)}}),
        toolCommand<ToolKind::laser>({.id = toolLaser,
                                      .tag = "laser",
                                      .name = "Laser erase",
                                      .icon = icon::kLaser,
                                      .chords = {key(GLFW_KEY_L)}}),
        toolCommand<ToolKind::fill>({.id = toolFill,
                                     .tag = "fill",
                                     .name = "Fill",
                                     .icon = icon::kFill,
                                     .chords = {key(GLFW_KEY_K)}}),
        toolCommand<ToolKind::planeFill>({.id = toolPlaneFill,
                                          .tag = "plane_fill",
                                          .name = "Fill a plane",
                                          .icon = icon::kPlaneFill,
                                          .chords = {key(GLFW_KEY_P)}}),
        toolCommand<ToolKind::stamp>({.id = toolStamp,
                                      .tag = "stamp",
                                      .name = "Stamp",
                                      .icon = icon::kStamp,
                                      .chords = {key(GLFW_KEY_X)}}),

        toolCommand<ToolKind::box>({.id = toolBox,
                                    .tag = "box",
                                    .name = "Box",
                                    .icon = icon::kBox,
                                    .chords = {key(GLFW_KEY_U)}}),
        toolCommand<ToolKind::line>({.id = toolLine,
                                     .tag = "line",
                                     .name = "Line",
                                     .icon = icon::kLine,
                                     .chords = {key(GLFW_KEY_N)}}),
        toolCommand<ToolKind::sphere>({.id = toolSphere,
                                       .tag = "sphere",
                                       .name = "Sphere",
                                       .icon = icon::kSphere,
                                       .chords = {key(GLFW_KEY_H)}}),
        toolCommand<ToolKind::ellipse>({.id = toolEllipse,
                                        .tag = "ellipse",
                                        .name = "Ellipsoid",
                                        .icon = icon::kEllipse,
                                        .chords = {key(GLFW_KEY_J)}}),
        toolCommand<ToolKind::cylinder>({.id = toolCylinder,
                                         .tag = "cylinder",
                                         .name = "Cylinder",
                                         .icon = icon::kCylinder,
                                         .chords = {key(GLFW_KEY_Y)}}),

        toolCommand<ToolKind::selectBox>({.id = toolSelectBox,
                                          .tag = "select_box",
                                          .name = "Select a box",
                                          .icon = icon::kSelectBox,
                                          .chords = {key(GLFW_KEY_M)}}),
        toolCommand<ToolKind::selectRectangle>({.id = toolSelectRectangle,
                                                .tag = "select_rectangle",
                                                .name = "Select on screen",
                                                .icon = icon::kSelectRectangle,
                                                .chords = {key(GLFW_KEY_Q)}}),
        toolCommand<ToolKind::wand>({.id = toolWand,
                                     .tag = "wand",
                                     .name = "Magic wand",
                                     .icon = icon::kWand,
                                     .chords = {key(GLFW_KEY_Z)}}),

        toolCommand<ToolKind::pickColour>({.id = toolPickColour,
                                           .tag = "pick_colour",
                                           .name = "Pick colour",
                                           .icon = icon::kPickColour,
                                           .chords = {key(GLFW_KEY_I)}}),
        toolCommand<ToolKind::anchor>({.id = toolAnchor,
                                       .tag = "set_anchor",
                                       .name = "Set anchor",
                                       .icon = icon::kPickAnchor,
                                       .chords = {key(GLFW_KEY_A)}}),
        toolCommand<ToolKind::socket>({.id = toolSocket,
                                       .tag = "socket",
                                       .name = "Place sockets",
                                       .icon = icon::kSocket,
                                       .chords = {key(GLFW_KEY_C)}}),

        gizmoCommand<GizmoKind::move>({.id = gizmoMove,
                                       .tag = "gizmo_move",
                                       .name = "Move proxy box",
                                       .icon = icon::kMove,
                                       .chords = {key(GLFW_KEY_W)},
                                       .separator = true}),
        gizmoCommand<GizmoKind::rotate>({.id = gizmoRotate,
                                         .tag = "gizmo_rotate",
                                         .name = "Rotate proxy box",
                                         .icon = icon::kRotate,
                                         .chords = {key(GLFW_KEY_E)}}),
        gizmoCommand<GizmoKind::scale>({.id = gizmoScale,
                                        .tag = "gizmo_scale",
                                        .name = "Scale proxy box",
                                        .icon = icon::kScale,
                                        .chords = {key(GLFW_KEY_S)}}),
    };
    return kCommands;
}

}  // namespace voxprite::editor
