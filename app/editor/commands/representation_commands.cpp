#include <cmath>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

RepresentationSettings& settingsOf(CommandContext& c) {
    return c.settings.scene.representations;
}
const RepresentationSettings& settingsOf(const CommandContext& c) {
    return c.settings.scene.representations;
}

template <DrawRule rule>
constexpr Command ruleCommand(Command command) {
    command.menu = MenuId::view;
    command.group = kSpriteViewGroup;
    command.run = [](CommandContext& c) { settingsOf(c).rule = rule; };
    command.on = [](const CommandContext& c) { return settingsOf(c).rule == rule; };
    return command;
}

void compare(CommandContext& c) {
    RepresentationSettings& settings = settingsOf(c);
    settings.compared = !settings.compared;
    settings.flying = false;
    if (settings.compared) c.settings.scene.comparison.cells = 0;
}

void fly(CommandContext& c) {
    if (!settingsOf(c).compared) compare(c);
    settingsOf(c).flying = !settingsOf(c).flying;
}

// A step of a third of an octave, nearer or farther.
template <int direction>
void step(CommandContext& c) {
    RepresentationSettings& settings = settingsOf(c);
    settings.flying = false;
    settings.comparedSizePx = std::clamp(settings.comparedSizePx * std::exp2(direction / 3.0),
                                         kLeastComparedPx, kMostComparedPx);
}

// The error budget, half or twice as large.
template <int direction>
void budget(CommandContext& c) {
    RepresentationSettings& settings = settingsOf(c);
    settings.errorBudget = std::clamp(settings.errorBudget * std::exp2(direction),
                                      kLeastErrorBudget, kMostErrorBudget);
}

bool isCompared(const CommandContext& c) {
    return settingsOf(c).compared;
}

}  // namespace

std::span<const Command> representationCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        ruleCommand<DrawRule::exact>({.id = drawExact,
                                      .tag = "draw_exact",
                                      .name = "Draw exact sprites",
                                      .separator = true}),
        ruleCommand<DrawRule::automatic>({.id = drawAutomatic,
                                          .tag = "draw_automatic",
                                          .name = "Draw what is cheapest within the budget"}),
        ruleCommand<DrawRule::snapshot>(
            {.id = drawSnapshots, .tag = "draw_snapshots", .name = "Draw snapshots"}),
        ruleCommand<DrawRule::clusters>(
            {.id = drawClusters, .tag = "draw_clusters", .name = "Draw clusters"}),
        ruleCommand<DrawRule::coarse>(
            {.id = drawCoarse, .tag = "draw_coarse", .name = "Draw coarser octrees"}),
        Command{.id = halveErrorBudget,
                .tag = "halve_error_budget",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Error budget: half",
                .run = budget<-1>},
        Command{.id = doubleErrorBudget,
                .tag = "double_error_budget",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Error budget: double",
                .run = budget<1>},
        Command{.id = tintByChoice,
                .tag = "tint_by_choice",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Tint entities by what they are drawn by",
                .run = [](CommandContext& c) { settingsOf(c).tint = !settingsOf(c).tint; },
                .on = [](const CommandContext& c) { return settingsOf(c).tint; }},
        Command{.id = compareRepresentations,
                .tag = "compare_representations",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Compare representations",
                .icon = icon::kLayers,
                .run = compare,
                .on = isCompared},
        Command{.id = flyRepresentations,
                .tag = "fly_representations",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Compare representations: fly from near to far",
                .icon = icon::kPlay,
                .run = fly,
                .on = [](const CommandContext& c) { return settingsOf(c).flying; }},
        Command{.id = representationsNearer,
                .tag = "representations_nearer",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Compare representations: nearer",
                .repeats = true,
                .run = step<1>,
                .enabled = isCompared},
        Command{.id = representationsFarther,
                .tag = "representations_farther",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Compare representations: farther",
                .repeats = true,
                .run = step<-1>,
                .enabled = isCompared},
    };
    return kCommands;
}

}  // namespace voxprite::editor
