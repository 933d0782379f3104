#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/overlays.h"
#include "app/editor/views/sprite_viewport.h"
#include "app/editor/views/voxel_viewport.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

template <class View>
void turn(View& view, double yawDegrees, double pitchDegrees) {
    OrbitCamera wanted = view.camera();
    wanted.yawDegrees = yawDegrees;
    wanted.pitchDegrees = pitchDegrees;
    view.turn().start(view.camera(), wanted);
}

// Both cameras look from there.
void look(CommandContext& c, double yawDegrees, double pitchDegrees) {
    turn(c.editView, yawDegrees, pitchDegrees);
    turn(c.spriteView, yawDegrees, pitchDegrees);
}

template <int yawDegrees, int pitchDegrees>
constexpr Command lookCommand(Command command) {
    command.menu = MenuId::view;
    command.group = "Look from";
    command.run = [](CommandContext& c) { look(c, yawDegrees, pitchDegrees); };
    return command;
}

// The eye on a diagonal of a cube.
constexpr double kIsometricPitchDegrees = 35.264389682754654;

// Around what floats, else what is selected, else the active object; entity space.
IBox selectedBox(const Session& session) {
    const VoxelSelection& selection = session.selection();
    if (selection.floating()) return selection.floating()->bounds();
    if (!selection.empty()) {
        for (const Instance& instance : session.instances()) {
            if (instance.node != selection.node()) continue;
            return instance.entityFromModel.applyToBox(selection.voxels().bounds());
        }
    }
    if (session.activeNode() < 0) return {};
    return nodeBounds(session.document(), session.activeNode(), session.frame());
}

template <bool ViewSettings::*flag>
constexpr Command switchCommand(Command command) {
    command.menu = MenuId::view;
    command.group = "Show";
    command.run = [](CommandContext& c) { c.settings.view.*flag = !(c.settings.view.*flag); };
    command.on = [](const CommandContext& c) { return c.settings.view.*flag; };
    return command;
}

template <VoxelOcclusion kind>
constexpr Command occlusionCommand(Command command) {
    command.menu = MenuId::view;
    command.group = "Show";
    command.run = [](CommandContext& c) { c.settings.view.occlusion = kind; };
    command.on = [](const CommandContext& c) { return c.settings.view.occlusion == kind; };
    return command;
}

template <DrawBy way>
constexpr Command drawByCommand(Command command) {
    command.menu = MenuId::view;
    command.group = "Draw voxels by";
    command.run = [](CommandContext& c) { c.settings.view.drawBy = way; };
    command.on = [](const CommandContext& c) { return c.settings.view.drawBy == way; };
    return command;
}

constexpr Command ungrouped(Command command) {
    command.group = "";
    return command;
}

template <bool WindowSettings::*flag>
constexpr Command panelCommand(Command command) {
    command.menu = MenuId::view;
    command.group = "Panels";
    command.run = [](CommandContext& c) { c.settings.window.*flag = !(c.settings.window.*flag); };
    command.on = [](const CommandContext& c) { return c.settings.window.*flag; };
    return command;
}

template <ThemeKind kind>
constexpr Command themeCommand(Command command) {
    command.menu = MenuId::view;
    command.run = [](CommandContext& c) { c.settings.window.theme = kind; };
    command.on = [](const CommandContext& c) { return c.settings.window.theme == kind; };
    return command;
}

}  // namespace

std::span<const Command> viewCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = frameModel,
                .tag = "frame_model",
                .menu = MenuId::view,
                .name = "Frame the model",
                .icon = icon::kFit,
                .chords = {key(GLFW_KEY_HOME)},
                .run =
                    [](CommandContext& c) {
                        c.editView.frameModel(c.session);
                        c.spriteView.frameModel(c.session);
                    }},
        Command{.id = frameSelection,
                .tag = "frame_selection",
                .menu = MenuId::view,
                .name = "Frame the selection",
                .chords = {key(GLFW_KEY_PERIOD)},
                .run = [](CommandContext& c) { c.editView.frameBox(selectedBox(c.session)); },
                .enabled = [](const CommandContext& c) { return !selectedBox(c.session).empty(); }},
        lookCommand<0, 0>({.id = viewFront,
                           .tag = "view_front",
                           .name = "From the front",
                           .chords = {key(GLFW_KEY_1)},
                           .separator = true}),
        lookCommand<180, 0>({.id = viewBack,
                             .tag = "view_back",
                             .name = "From the back",
                             .chords = {control(GLFW_KEY_1)}}),
        lookCommand<90, 0>({.id = viewRight,
                            .tag = "view_right",
                            .name = "From the right",
                            .chords = {key(GLFW_KEY_3)}}),
        lookCommand<-90, 0>({.id = viewLeft,
                             .tag = "view_left",
                             .name = "From the left",
                             .chords = {control(GLFW_KEY_3)}}),
        lookCommand<0, 90>(
            {.id = viewTop, .tag = "view_top", .name = "From above", .chords = {key(GLFW_KEY_7)}}),
        lookCommand<0, -90>({.id = viewBottom,
                             .tag = "view_bottom",
                             .name = "From below",
                             .chords = {control(GLFW_KEY_7)}}),
        Command{.id = viewIsometric,
                .tag = "view_isometric",
                .menu = MenuId::view,
                .group = "Look from",
                .name = "Isometric",
                .icon = icon::kIsometric,
                .chords = {key(GLFW_KEY_9)},
                .run = [](CommandContext& c) { look(c, 45.0, kIsometricPitchDegrees); }},
        Command{.id = toggleOrthographic,
                .tag = "orthographic",
                .menu = MenuId::view,
                .name = "Without perspective",
                .icon = icon::kPerspective,
                .chords = {key(GLFW_KEY_5)},
                .run =
                    [](CommandContext& c) {
                        bool& flag = c.editView.camera().orthographic;
                        flag = !flag;
                    },
                .on = [](const CommandContext& c) { return c.editView.camera().orthographic; }},
        ungrouped(switchCommand<&ViewSettings::lockCameras>({.id = toggleLockCameras,
                                                             .tag = "lock_cameras",
                                                             .name = "Lock the cameras together",
                                                             .icon = icon::kLink,
                                                             .chords = {shift(GLFW_KEY_L)}})),
        switchCommand<&ViewSettings::voxelEdges>(
            {.id = toggleEdges, .tag = "voxel_edges", .name = "Voxel edges", .separator = true}),
        switchCommand<&ViewSettings::editGround>(
            {.id = toggleEditGround, .tag = "edit_ground", .name = "Grid under the model"}),
        switchCommand<&ViewSettings::boundsBox>(
            {.id = toggleBounds, .tag = "bounds", .name = "Box around the model"}),
        occlusionCommand<VoxelOcclusion::off>(
            {.id = occlusionOff, .tag = "occlusion_off", .name = "No shade between voxels"}),
        occlusionCommand<VoxelOcclusion::corners>(
            {.id = occlusionCorners, .tag = "occlusion_corners", .name = "Shade in corners"}),
        occlusionCommand<VoxelOcclusion::rays>(
            {.id = occlusionRays, .tag = "occlusion_rays", .name = "Shade by short rays"}),
        switchCommand<&ViewSettings::sunShadow>(
            {.id = toggleSunShadow, .tag = "sun_shadow", .name = "Shadows in the edit view"}),
        switchCommand<&ViewSettings::proxyBox>({.id = toggleProxyBox,
                                                .tag = "proxy_box",
                                                .name = "Proxy box",
                                                .icon = icon::kWireframe,
                                                .chords = {shift(GLFW_KEY_P)},
                                                .separator = true}),
        switchCommand<&ViewSettings::anchorMarker>({.id = toggleAnchorMarker,
                                                    .tag = "anchor_marker",
                                                    .name = "Anchor marker",
                                                    .icon = icon::kAnchor,
                                                    .chords = {key(GLFW_KEY_O)}}),
        switchCommand<&ViewSettings::groundGrid>(
            {.id = toggleGroundGrid, .tag = "ground_grid", .name = "Ground lines, one a metre"}),
        switchCommand<&ViewSettings::shadow>(
            {.id = toggleShadow, .tag = "shadow", .name = "Shadow in the game scene"}),
        drawByCommand<DrawBy::automatic>(
            {.id = drawByAutomatic, .tag = "draw_by_automatic", .name = "What is faster"}),
        drawByCommand<DrawBy::rays>(
            {.id = drawByRays, .tag = "draw_by_rays", .name = "Rays: one for each pixel"}),
        drawByCommand<DrawBy::clusters>(
            {.id = drawByClusters, .tag = "draw_by_clusters", .name = "Clusters of a mesh"}),
        Command{.id = toggleClusterTint,
                .tag = "cluster_tint",
                .menu = MenuId::view,
                .group = "Draw voxels by",
                .name = "Tint clusters by level of detail",
                .separator = true,
                .run =
                    [](CommandContext& c) {
                        ViewSettings& view = c.settings.view;
                        view.tintClusters = !view.tintClusters;
                        // Rays have no levels.
                        if (view.tintClusters) view.drawBy = DrawBy::clusters;
                    },
                .on = [](const CommandContext& c) { return c.settings.view.tintClusters; }},
        Command{.id = savedCameras,
                .tag = "saved_cameras",
                .menu = MenuId::view,
                .name = "Saved views…",
                .icon = icon::kCamera,
                .chords = {key(GLFW_KEY_V)},
                .separator = true,
                .run = [](CommandContext& c) { c.overlays.cameras.open(); }},
        panelCommand<&WindowSettings::showsTools>(
            {.id = toggleTools, .tag = "show_tools", .name = "Tool column", .separator = true}),
        panelCommand<&WindowSettings::showsSide>(
            {.id = toggleSide, .tag = "show_side", .name = "Side panels"}),
        panelCommand<&WindowSettings::showsDock>(
            {.id = toggleDock, .tag = "show_dock", .name = "Palette and lists"}),
        Command{.id = togglePanels,
                .tag = "show_panels",
                .menu = MenuId::view,
                .group = "Panels",
                .name = "Nothing but the views",
                .chords = {key(GLFW_KEY_TAB)},
                .run =
                    [](CommandContext& c) {
                        WindowSettings& window = c.settings.window;
                        const bool show = !window.showsTools && !window.showsSide;
                        window.showsTools = window.showsSide = show;
                    },
                .on =
                    [](const CommandContext& c) {
                        const WindowSettings& window = c.settings.window;
                        return !window.showsTools && !window.showsSide;
                    }},
        themeCommand<ThemeKind::dark>({.id = themeDark,
                                       .tag = "theme_dark",
                                       .name = "Dark theme",
                                       .icon = icon::kDark,
                                       .separator = true}),
        themeCommand<ThemeKind::light>(
            {.id = themeLight, .tag = "theme_light", .name = "Light theme", .icon = icon::kLight}),
    };
    return kCommands;
}

}  // namespace voxprite::editor
