#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/icons.h"
#include "core/edit/scene_edits.h"

namespace voxprite::editor {
namespace {

bool hasActiveObject(const CommandContext& context) {
    return context.session.activeNode() > 0;
}

void activateNewest(CommandContext& context) {
    context.session.setActiveNode(static_cast<int>(context.session.document().nodes.size()) - 1);
}

}  // namespace

std::span<const Command> objectCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = addObject,
                .tag = "add_object",
                .menu = MenuId::edit,
                .name = "Add object",
                .icon = icon::kPlus,
                .separator = true,
                .run =
                    [](CommandContext& c) {
                        const Document& document = c.session.document();
                        const auto number = std::to_string(document.nodes.size());
                        c.perform(voxprite::addObject(document, "Object " + number));
                        activateNewest(c);
                    }},
        Command{.id = duplicateObject,
                .tag = "duplicate_object",
                .menu = MenuId::edit,
                .name = "Duplicate object",
                .icon = icon::kCopy,
                .chords = {controlShift(GLFW_KEY_D)},
                .run =
                    [](CommandContext& c) {
                        c.perform(
                            duplicateNode(c.session.document(), c.session.activeNode(), Copy::own));
                        activateNewest(c);
                    },
                .enabled = hasActiveObject},
        Command{.id = deleteObject,
                .tag = "delete_object",
                .menu = MenuId::edit,
                .name = "Delete object",
                .icon = icon::kDelete,
                .run =
                    [](CommandContext& c) {
                        const std::array nodes{c.session.activeNode()};
                        c.perform(deleteNodes(c.session.document(), nodes));
                    },
                .enabled = hasActiveObject},
    };
    return kCommands;
}

}  // namespace voxprite::editor
