#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/views/sprite_viewport.h"
#include "app/editor/window/icons.h"
#include "core/edit/make_action.h"
#include "core/io/formats.h"

namespace voxprite::editor {
namespace {

// Splits the sprite view into so many cells, or makes it one again.
template <int cells>
constexpr Command compareCommand(Command command) {
    command.menu = MenuId::view;
    command.group = kSpriteViewGroup;
    command.run = [](CommandContext& c) {
        SigmaComparison& comparison = c.settings.scene.comparison;
        comparison.open(comparison.cells == cells ? 0 : cells, c.session.profile().sigma);
        c.settings.scene.representations.compared = false;
    };
    command.on = [](const CommandContext& c) { return c.settings.scene.comparison.cells == cells; };
    return command;
}

template <int screenPx>
constexpr Command distanceCommand(Command command) {
    command.menu = MenuId::view;
    command.group = kSpriteViewGroup;
    command.run = [](CommandContext& c) { c.spriteView.toGameDistance(c.session, screenPx); };
    command.enabled = [](const CommandContext& c) { return !c.session.bounds().empty(); };
    return command;
}

bool isSinglePass(const CommandContext& c) {
    return c.session.profile().mode == SpriteMode::singlePass;
}

void addModel(CommandContext& c) {
    c.files.browse(
        {.title = "Add a model to the scene", .button = "Add", .extensions = modelEndings()},
        [](CommandContext& context, const std::filesystem::path& file) {
            context.files.addToScene(file);
        });
}

}  // namespace

std::span<const Command> sceneCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        compareCommand<2>({.id = compareTwo,
                           .tag = "compare_two",
                           .name = "Compare two sigmas",
                           .icon = icon::kTwoCells,
                           .separator = true}),
        compareCommand<4>({.id = compareFour,
                           .tag = "compare_four",
                           .name = "Compare four sigmas",
                           .icon = icon::kFourCells}),
        distanceCommand<4>({.id = gameDistance4,
                            .tag = "game_distance_4",
                            .name = "Game distance: 4 screen pixels a virtual pixel",
                            .separator = true}),
        distanceCommand<2>({.id = gameDistance2,
                            .tag = "game_distance_2",
                            .name = "Game distance: 2 screen pixels a virtual pixel"}),
        distanceCommand<1>({.id = gameDistance1,
                            .tag = "game_distance_1",
                            .name = "Game distance: 1 screen pixel a virtual pixel"}),
        Command{.id = frameScene,
                .tag = "frame_scene",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Frame the whole scene",
                .icon = icon::kPeople,
                .run = [](CommandContext& c) { c.spriteView.frameScene(c.session); }},
        Command{.id = addSceneModel,
                .tag = "add_scene_model",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Add a model to the scene…",
                .icon = icon::kPlus,
                .run = addModel},
        Command{.id = toggleSinglePass,
                .tag = "single_pass",
                .menu = MenuId::view,
                .group = kSpriteViewGroup,
                .name = "Draw sprites in a single pass",
                .run =
                    [](CommandContext& c) {
                        GameProfile after = c.session.profile();
                        after.mode =
                            isSinglePass(c) ? SpriteMode::spriteBuffer : SpriteMode::singlePass;
                        c.perform(makeAction("Mode", ProfileEdit{c.session.profile(), after}));
                    },
                .on = isSinglePass},
    };
    return kCommands;
}

}  // namespace voxprite::editor
