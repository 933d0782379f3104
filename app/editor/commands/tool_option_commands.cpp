#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/tools/guides.h"
#include "app/editor/views/voxel_viewport.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

ToolOptions& optionsOf(const CommandContext& context) {
    return context.settings.tool.options;
}

// A tenth at a time, so that large tips do not take forever.
template <int way>
constexpr Command tipCommand(Command command) {
    command.menu = MenuId::tool;
    command.repeats = true;
    command.run = [](CommandContext& c) {
        int& edge = optionsOf(c).tipEdge;
        edge = std::clamp(edge + way * std::max(1, edge / 10), 1, kMaxTipEdge);
    };
    return command;
}

template <int axis>
constexpr Command mirrorCommand(Command command) {
    command.menu = MenuId::tool;
    command.run = [](CommandContext& c) { switchSymmetry(optionsOf(c), axis, c.session.bounds()); };
    command.on = [](const CommandContext& c) { return optionsOf(c).symmetry.on[axis]; };
    return command;
}

bool toolIsBusy(const CommandContext& context) {
    return context.editView.tools().busy();
}

}  // namespace

std::span<const Command> toolOptionCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = keepMade,
                .tag = "keep_made",
                .menu = MenuId::tool,
                .name = "Keep what is being made",
                .icon = icon::kCheck,
                .chords = {key(GLFW_KEY_ENTER), key(GLFW_KEY_KP_ENTER)},
                .separator = true,
                .run =
                    [](CommandContext& c) {
                        auto action = c.editView.tools().confirm(c.session);
                        if (action) c.perform(std::move(*action));
                    },
                .enabled = toolIsBusy},
        Command{.id = dropMade,
                .tag = "drop_made",
                .menu = MenuId::tool,
                .name = "Drop what is being made",
                .icon = icon::kClose,
                .chords = {key(GLFW_KEY_ESCAPE)},
                .run = [](CommandContext& c) { c.editView.tools().cancel(c.session); },
                .enabled = toolIsBusy},
        tipCommand<-1>({.id = tipSmaller,
                        .tag = "tip_smaller",
                        .name = "Smaller brush",
                        .icon = icon::kMinus,
                        .chords = {key(GLFW_KEY_MINUS), key(GLFW_KEY_KP_SUBTRACT)},
                        .separator = true}),
        tipCommand<+1>({.id = tipLarger,
                        .tag = "tip_larger",
                        .name = "Larger brush",
                        .icon = icon::kPlus,
                        .chords = {key(GLFW_KEY_EQUAL), key(GLFW_KEY_KP_ADD)}}),
        Command{.id = toggleHollow,
                .tag = "hollow",
                .menu = MenuId::tool,
                .name = "Hollow shapes",
                .run = [](CommandContext& c) { optionsOf(c).hollow = !optionsOf(c).hollow; },
                .on = [](const CommandContext& c) { return optionsOf(c).hollow; }},
        mirrorCommand<0>({.id = mirrorX,
                          .tag = "mirror_x",
                          .name = "Mirror left and right",
                          .chords = {shift(GLFW_KEY_X)},
                          .separator = true}),
        mirrorCommand<1>({.id = mirrorY,
                          .tag = "mirror_y",
                          .name = "Mirror front and back",
                          .chords = {shift(GLFW_KEY_Y)}}),
        mirrorCommand<2>({.id = mirrorZ,
                          .tag = "mirror_z",
                          .name = "Mirror top and bottom",
                          .chords = {shift(GLFW_KEY_Z)}}),
        Command{.id = centreMirrors,
                .tag = "centre_mirrors",
                .menu = MenuId::tool,
                .name = "Centre the mirrors on the model",
                .run = [](CommandContext& c) { centreSymmetry(optionsOf(c), c.session.bounds()); }},
        Command{.id = toggleLimits,
                .tag = "limits",
                .menu = MenuId::tool,
                .name = "Limit edits to a box",
                .icon = icon::kWireframe,
                .run = [](CommandContext& c) { switchLimits(optionsOf(c), c.session.bounds()); },
                .on = [](const CommandContext& c) { return optionsOf(c).limited; }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
