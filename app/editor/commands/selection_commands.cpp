#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <functional>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/toasts.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/session/selection_edits.h"
#include "app/editor/views/voxel_viewport.h"
#include "app/editor/window/icons.h"
#include "core/edit/reshape.h"

namespace voxprite::editor {
namespace {

// One that shows: what lies in another frame is not what a command means.
bool hasSelection(const CommandContext& c) {
    return selectionShows(c.session);
}
bool hasFloating(const CommandContext& c) {
    return c.session.selection().floating().has_value();
}
bool hasAnything(const CommandContext& c) {
    return hasFloating(c) || !c.session.bounds().empty();
}
bool movesSomething(const CommandContext& c) {
    return hasFloating(c) || hasSelection(c) || c.settings.tool.tool == ToolKind::move;
}

void makeNow(CommandContext& c, Result<Action> action,
             const std::function<void()>& afterwards = {}) {
    if (!action) return c.report(Failure(action.error()));
    c.perform(std::move(*action), afterwards);
}

void takeMoveTool(CommandContext& c) {
    if (c.settings.tool.tool != ToolKind::move) c.settings.tool.choose(ToolKind::move);
}

// Whatever is put into the air is shown, and put down, by the Move tool.
void floatNow(CommandContext& c, const Status& lifted) {
    if (!lifted) return c.report(lifted);
    takeMoveTool(c);
}

// Lifts what is not yet in the air, and changes how it lies.
template <class Change>
void rearrange(CommandContext& c, const Change& change) {
    const auto& floating = c.session.selection().floating();
    if (!floating || floating->kind != Floating::Kind::move) {
        if (!c.settle()) return;
        const Status lifted = lift(c.session, c.settings.tool, Floating::Kind::move);
        if (!lifted) return c.report(lifted);
    }
    c.session.selection().changeFloating(change);
    takeMoveTool(c);
}

// The axis of entity space, and its sign, that comes nearest to a direction of the camera's picture
// on the ground: arrow keys move things where they point.
glm::ivec3 onGround(glm::dvec3 world) {
    const glm::dvec3 d = voxelFromWorld(world);
    if (std::abs(d.x) >= std::abs(d.y)) return {d.x < 0.0 ? -1 : 1, 0, 0};
    return {0, d.y < 0.0 ? -1 : 1, 0};
}

glm::ivec3 rightOf(const CommandContext& c) {
    return onGround(c.editView.camera().camera({1, 1}).right);
}
glm::ivec3 awayFrom(const CommandContext& c) {
    const Camera camera = c.editView.camera().camera({1, 1});
    // From straight above, what is up in the picture lies away.
    const bool steep = std::abs(camera.forward.y) > std::abs(camera.up.y);
    return onGround(steep ? camera.up * (camera.forward.y < 0.0 ? 1.0 : -1.0) : camera.forward);
}

template <int way>
void nudgeAcross(CommandContext& c) {
    rearrange(c, [by = rightOf(c) * way](Floating& f) { f.moveBy(by); });
}
template <int way>
void nudgeAway(CommandContext& c) {
    rearrange(c, [by = awayFrom(c) * way](Floating& f) { f.moveBy(by); });
}
template <int way>
void nudgeUp(CommandContext& c) {
    rearrange(c, [](Floating& f) { f.moveBy({0, 0, way}); });
}
template <int axis, int turns>
void turn(CommandContext& c) {
    rearrange(c, [](Floating& f) { f.turn(axis, turns); });
}
template <int axis>
void flip(CommandContext& c) {
    rearrange(c, [](Floating& f) { f.flip(axis); });
}
void scaleUp(CommandContext& c) {
    rearrange(c, [](Floating& f) {
        f.amount = std::min(f.amount + 1, Floating::greatestAmount(Floating::Kind::move));
    });
}

// A selection floats until it is put down; the whole object, beside which there is nothing to lose,
// goes there at once.
template <glm::ivec3 (*offset)(const IBox&)>
void placeBy(CommandContext& c) {
    const bool selected = hasSelection(c) || hasFloating(c);
    rearrange(c, [](Floating& f) {
        f.moveBy(offset(f.bounds()));
        f.label = "Place the object";
    });
    if (!selected) static_cast<void>(c.settle());
}

template <Floating::Kind kind>
void reshape(CommandContext& c) {
    floatNow(c, lift(c.session, c.settings.tool, kind));
}

template <Floating::Kind kind>
constexpr Command reshapeCommand(Command command) {
    command.menu = MenuId::select;
    command.group = "Reshape";
    command.settles = true;
    command.run = reshape<kind>;
    command.enabled = hasAnything;
    return command;
}

constexpr Command arrangeCommand(const char* group, Command command) {
    command.menu = MenuId::select;
    command.group = group;
    command.repeats = true;
    command.enabled = std::string_view(group) == "Move" ? movesSomething : hasAnything;
    return command;
}

}  // namespace

std::span<const Command> clipboardCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = cutVoxels,
                .tag = "cut",
                .menu = MenuId::edit,
                .name = "Cut",
                .icon = icon::kCut,
                .chords = {control(GLFW_KEY_X)},
                .separator = true,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        if (const Status copied = copySelection(c.session); !copied) {
                            return c.report(copied);
                        }
                        makeNow(c, deleteSelection(c.session, "Cut"));
                    },
                .enabled = hasSelection},
        Command{.id = copyVoxels,
                .tag = "copy",
                .menu = MenuId::edit,
                .name = "Copy",
                .icon = icon::kCopy,
                .chords = {control(GLFW_KEY_C)},
                .settles = true,
                .run = [](CommandContext& c) { c.report(copySelection(c.session)); },
                .enabled = hasAnything},
        Command{.id = pasteVoxels,
                .tag = "paste",
                .menu = MenuId::edit,
                .name = "Paste",
                .icon = icon::kPaste,
                .chords = {control(GLFW_KEY_V)},
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        std::string said;
                        if (const Status fits = fitClip(c.session, said); !fits) {
                            return c.report(fits);
                        }
                        if (!said.empty()) c.toasts.info(said);
                        floatNow(c, pasteClip(c.session));
                    },
                .enabled = [](const CommandContext& c) { return c.session.clip() != nullptr; }},
        Command{.id = duplicateVoxels,
                .tag = "duplicate",
                .menu = MenuId::edit,
                .name = "Duplicate",
                .icon = icon::kDuplicate,
                .chords = {control(GLFW_KEY_D)},
                .settles = true,
                .run = [](CommandContext& c) { floatNow(c, duplicateSelection(c.session)); },
                .enabled = hasAnything},
        Command{.id = deleteVoxels,
                .tag = "delete",
                .menu = MenuId::edit,
                .name = "Delete",
                .icon = icon::kDelete,
                .chords = {key(GLFW_KEY_DELETE)},
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        // What floats goes with what it was lifted from.
                        makeNow(c, deleteSelection(c.session, "Delete"));
                    },
                .enabled = hasSelection},
    };
    return kCommands;
}

std::span<const Command> selectionCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = selectAllVoxels,
                .tag = "select_all",
                .menu = MenuId::select,
                .name = "All",
                .icon = icon::kSelectAll,
                .chords = {control(GLFW_KEY_A)},
                .settles = true,
                .run = [](CommandContext& c) { c.report(selectEverything(c.session)); },
                .enabled = hasAnything},
        Command{.id = selectNone,
                .tag = "select_none",
                .menu = MenuId::select,
                .name = "None",
                .icon = icon::kSelectNone,
                .chords = {controlShift(GLFW_KEY_A)},
                .settles = true,
                .run = [](CommandContext& c) { c.session.selection().clear(); },
                .enabled =
                    [](const CommandContext& c) {
                        return !c.session.selection().empty() || hasFloating(c);
                    }},
        Command{.id = invertSelected,
                .tag = "invert_selection",
                .menu = MenuId::select,
                .name = "Invert",
                .icon = icon::kInvert,
                .chords = {control(GLFW_KEY_I)},
                .settles = true,
                .run = [](CommandContext& c) { c.report(invertSelection(c.session)); },
                .enabled = hasAnything},
        Command{.id = selectByColour,
                .tag = "select_colour",
                .menu = MenuId::select,
                .name = "All of the colour in hand",
                .icon = icon::kPalette,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.report(selectColour(c.session, c.settings.tool.colour));
                    },
                .enabled = hasAnything},
        Command{
            .id = editInsideSelection,
            .tag = "edit_inside_selection",
            .menu = MenuId::select,
            .name = "Paint and erase only what is selected",
            .icon = icon::kInside,
            .run =
                [](CommandContext& c) {
                    bool& inside = c.settings.tool.options.insideSelection;
                    inside = !inside;
                },
            .on = [](const CommandContext& c) { return c.settings.tool.options.insideSelection; }},
        Command{
            .id = toolMove,
            .tag = "move_voxels",
            .menu = MenuId::select,
            .name = "Move voxels",
            .icon = icon::kMoveVoxels,
            .chords = {control(GLFW_KEY_T)},
            .separator = true,
            .run = [](CommandContext& c) { takeMoveTool(c); },
            .on = [](const CommandContext& c) { return c.settings.tool.tool == ToolKind::move; }},
        arrangeCommand("Move", {.id = nudgeRight,
                                .tag = "nudge_right",
                                .name = "Move voxels right",
                                .chords = {key(GLFW_KEY_RIGHT)},
                                .run = nudgeAcross<+1>}),
        arrangeCommand("Move", {.id = nudgeLeft,
                                .tag = "nudge_left",
                                .name = "Move voxels left",
                                .chords = {key(GLFW_KEY_LEFT)},
                                .run = nudgeAcross<-1>}),
        arrangeCommand("Move", {.id = nudgeBack,
                                .tag = "nudge_back",
                                .name = "Move voxels away",
                                .chords = {key(GLFW_KEY_UP)},
                                .run = nudgeAway<+1>}),
        arrangeCommand("Move", {.id = nudgeFront,
                                .tag = "nudge_front",
                                .name = "Move voxels nearer",
                                .chords = {key(GLFW_KEY_DOWN)},
                                .run = nudgeAway<-1>}),
        arrangeCommand("Move", {.id = nudgeRaise,
                                .tag = "nudge_up",
                                .name = "Move voxels up",
                                .chords = {key(GLFW_KEY_PAGE_UP)},
                                .run = nudgeUp<+1>}),
        arrangeCommand("Move", {.id = nudgeLower,
                                .tag = "nudge_down",
                                .name = "Move voxels down",
                                .chords = {key(GLFW_KEY_PAGE_DOWN)},
                                .run = nudgeUp<-1>}),
        arrangeCommand("Turn and flip", {.id = turnVoxelsX,
                                         .tag = "turn_voxels_x",
                                         .name = "Turn voxels about X",
                                         .icon = icon::kTurn,
                                         .run = turn<0, 1>}),
        arrangeCommand("Turn and flip", {.id = turnVoxelsY,
                                         .tag = "turn_voxels_y",
                                         .name = "Turn voxels about Y",
                                         .icon = icon::kTurn,
                                         .run = turn<1, 1>}),
        arrangeCommand("Turn and flip", {.id = turnVoxelsZ,
                                         .tag = "turn_voxels_z",
                                         .name = "Turn voxels about Z",
                                         .icon = icon::kTurn,
                                         .chords = {control(GLFW_KEY_R)},
                                         .run = turn<2, 1>}),
        arrangeCommand("Turn and flip", {.id = turnVoxelsBackZ,
                                         .tag = "turn_voxels_back_z",
                                         .name = "Turn voxels back about Z",
                                         .icon = icon::kTurnBack,
                                         .chords = {controlShift(GLFW_KEY_R)},
                                         .run = turn<2, 3>}),
        arrangeCommand("Turn and flip", {.id = flipVoxelsX,
                                         .tag = "flip_voxels_x",
                                         .name = "Flip voxels left and right",
                                         .icon = icon::kMirrorX,
                                         .separator = true,
                                         .run = flip<0>}),
        arrangeCommand("Turn and flip", {.id = flipVoxelsY,
                                         .tag = "flip_voxels_y",
                                         .name = "Flip voxels front and back",
                                         .icon = icon::kMirrorY,
                                         .run = flip<1>}),
        arrangeCommand("Turn and flip", {.id = flipVoxelsZ,
                                         .tag = "flip_voxels_z",
                                         .name = "Flip voxels top and bottom",
                                         .icon = icon::kMirrorZ,
                                         .run = flip<2>}),
        Command{.id = scaleVoxels,
                .tag = "scale_voxels",
                .menu = MenuId::select,
                .name = "Scale by a whole number",
                .icon = icon::kScaleVoxels,
                .run = scaleUp,
                .enabled = hasAnything},
        Command{.id = recolourVoxels,
                .tag = "recolour_selection",
                .menu = MenuId::select,
                .name = "Recolour to the colour in hand",
                .icon = icon::kPaint,
                .separator = true,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        makeNow(c, recolourSelection(c.session, c.settings.tool.colour));
                    },
                .enabled = hasSelection},
        Command{.id = cropVoxels,
                .tag = "crop",
                .menu = MenuId::select,
                .name = "Crop the object to the selection",
                .icon = icon::kCrop,
                .settles = true,
                .run = [](CommandContext& c) { makeNow(c, cropToSelection(c.session)); },
                .enabled = hasSelection},
        Command{.id = voxelsToObject,
                .tag = "selection_to_object",
                .menu = MenuId::select,
                .name = "To a new object",
                .icon = icon::kObject,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        const auto node = static_cast<int>(c.session.document().nodes.size());
                        makeNow(c, selectionToObject(c.session),
                                [&c, node] { c.objects.choose(c.session, node); });
                    },
                .enabled = hasSelection},
        reshapeCommand<Floating::Kind::hollow>(
            {.id = hollowOut, .tag = "hollow_out", .name = "Hollow out…", .separator = true}),
        reshapeCommand<Floating::Kind::dilate>(
            {.id = dilateVoxels, .tag = "dilate", .name = "Dilate…"}),
        reshapeCommand<Floating::Kind::erode>(
            {.id = erodeVoxels, .tag = "erode", .name = "Erode…"}),
        reshapeCommand<Floating::Kind::smooth>(
            {.id = smoothVoxels, .tag = "smooth", .name = "Smooth…"}),
        Command{.id = centreVoxels,
                .tag = "centre_voxels",
                .menu = MenuId::select,
                .group = "Place",
                .name = "Centre on the origin",
                .run = placeBy<offsetToCentre>,
                .enabled = hasAnything},
        Command{.id = dropToGround,
                .tag = "drop_to_ground",
                .menu = MenuId::select,
                .group = "Place",
                .name = "Drop to the ground",
                .run = placeBy<offsetToGround>,
                .enabled = hasAnything},
        Command{.id = trimToLimits,
                .tag = "trim_to_limits",
                .menu = MenuId::select,
                .group = "Place",
                .name = "Trim to the limiting box",
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        makeNow(c, trimToBox(c.session, c.settings.tool.options.limits));
                    },
                .enabled =
                    [](const CommandContext& c) {
                        return hasAnything(c) && c.settings.tool.options.limited;
                    }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
