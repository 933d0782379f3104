#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/views/voxel_viewport.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {

std::span<const Command> editCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = undo,
                .tag = "undo",
                .menu = MenuId::edit,
                .name = "Undo",
                .icon = icon::kUndo,
                .chords = {control(GLFW_KEY_Z)},
                .repeats = true,
                .run =
                    [](CommandContext& c) {
                        // What is only being made is the first thing to take back.
                        ToolBox& tools = c.editView.tools();
                        if (tools.busy()) return tools.cancel(c.session);
                        c.undo();
                    },
                .enabled =
                    [](const CommandContext& c) {
                        return c.session.history().canUndo() || c.editView.tools().busy();
                    }},
        Command{.id = redo,
                .tag = "redo",
                .menu = MenuId::edit,
                .name = "Redo",
                .icon = icon::kRedo,
                .chords = {control(GLFW_KEY_Y), controlShift(GLFW_KEY_Z)},
                .repeats = true,
                .run =
                    [](CommandContext& c) {
                        c.editView.tools().cancel(c.session);
                        c.redo();
                    },
                .enabled = [](const CommandContext& c) { return c.session.history().canRedo(); }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
