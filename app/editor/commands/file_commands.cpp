#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/overlays.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/views/sprite_export.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

bool hasVoxels(const CommandContext& context) {
    return !context.session.bounds().empty();
}

}  // namespace

std::span<const Command> fileCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = newFile,
                .tag = "new",
                .menu = MenuId::file,
                .name = "New",
                .icon = icon::kFile,
                .chords = {control(GLFW_KEY_N)},
                .run = [](CommandContext& c) { c.files.startNew(); }},
        Command{.id = open,
                .tag = "open",
                .menu = MenuId::file,
                .name = "Open…",
                .icon = icon::kOpen,
                .chords = {control(GLFW_KEY_O)},
                .run = [](CommandContext& c) { c.files.open(); }},
        Command{.id = save,
                .tag = "save",
                .menu = MenuId::file,
                .name = "Save",
                .icon = icon::kSave,
                .chords = {control(GLFW_KEY_S)},
                .separator = true,
                .run = [](CommandContext& c) { c.files.save(); }},
        Command{.id = saveAs,
                .tag = "save_as",
                .menu = MenuId::file,
                .name = "Save as…",
                .chords = {controlShift(GLFW_KEY_S)},
                .run = [](CommandContext& c) { c.files.saveAs(); }},
        Command{.id = exportOctree,
                .tag = "export_octree",
                .menu = MenuId::file,
                .name = "Export octree…",
                .icon = icon::kExport,
                .chords = {control(GLFW_KEY_E)},
                .run = [](CommandContext& c) { c.files.exportOctree(); }},
        Command{.id = exportSheet,
                .tag = "export_sheet",
                .menu = MenuId::file,
                .name = "Export sprite sheet…",
                .icon = icon::kGrid,
                .chords = {controlShift(GLFW_KEY_E)},
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.overlays.sheet.open(c.session, c.settings.window.folder);
                    },
                .enabled = hasVoxels},
        Command{.id = saveSprite,
                .tag = "save_sprite",
                .menu = MenuId::file,
                .name = "Save this sprite as PNG",
                .icon = icon::kPicture,
                .chords = {key(GLFW_KEY_F12)},
                .run = saveSpritePicture,
                .enabled = hasVoxels},
        Command{.id = copySprite,
                .tag = "copy_sprite",
                .menu = MenuId::file,
                .name = "Copy this sprite",
                .icon = icon::kCopy,
                .chords = {controlShift(GLFW_KEY_C)},
                .run = copySpritePicture,
                .enabled = hasVoxels},
        Command{.id = openProfile,
                .tag = "open_profile",
                .menu = MenuId::file,
                .name = "Open game profile…",
                .separator = true,
                .run = [](CommandContext& c) { c.files.openProfile(); }},
        Command{.id = saveProfile,
                .tag = "save_profile",
                .menu = MenuId::file,
                .name = "Save game profile",
                .run = [](CommandContext& c) { c.files.saveProfile(); },
                .enabled =
                    [](const CommandContext& c) {
                        return c.session.profileFile().has_value() && c.session.profileUnsaved();
                    }},
        Command{.id = saveProfileAs,
                .tag = "save_profile_as",
                .menu = MenuId::file,
                .name = "Save game profile as…",
                .run = [](CommandContext& c) { c.files.saveProfileAs(); }},
        Command{.id = quit,
                .tag = "quit",
                .menu = MenuId::file,
                .name = "Quit",
                .chords = {control(GLFW_KEY_Q)},
                .separator = true,
                .run = [](CommandContext& c) { c.files.quit(); }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
