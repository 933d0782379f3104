#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/about.h"
#include "app/editor/panels/dialogs.h"
#include "app/editor/panels/overlays.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {

std::span<const Command> helpCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{
            .id = preferences,
            .tag = "preferences",
            .menu = MenuId::edit,
            .name = "Preferences…",
            .icon = icon::kSettings,
            .chords = {control(GLFW_KEY_COMMA)},
            .separator = true,
            .run =
                [](CommandContext& c) { c.overlays.preferences.open(Preferences::Page::general); }},
        Command{.id = commandPalette,
                .tag = "command_palette",
                .menu = MenuId::help,
                .name = "Find a command…",
                .icon = icon::kSearch,
                .chords = {control(GLFW_KEY_P), controlShift(GLFW_KEY_P)},
                .run = [](CommandContext& c) { c.overlays.palette.open(); }},
        Command{
            .id = keyList,
            .tag = "keys",
            .menu = MenuId::help,
            .name = "Keys…",
            .icon = icon::kKeyboard,
            .chords = {key(GLFW_KEY_F1)},
            .run = [](CommandContext& c) { c.overlays.preferences.open(Preferences::Page::keys); }},
        Command{.id = CommandId::tour,
                .tag = "tour",
                .menu = MenuId::help,
                .name = "Tour of the window",
                .icon = icon::kHelp,
                .run = [](CommandContext& c) { c.overlays.tour.open(); }},
        Command{.id = about,
                .tag = "about",
                .menu = MenuId::help,
                .name = "About voxprite",
                .icon = icon::kInfo,
                .separator = true,
                .run = [](CommandContext& c) { c.dialogs.showAbout(aboutLines()); }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
