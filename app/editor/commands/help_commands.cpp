#include "app/editor/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/icons.h"
#include "app/editor/panels/dialogs.h"
#include "render/gl/context.h"

namespace voxprite::editor {

std::span<const Command> helpCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = about,
                .tag = "about",
                .menu = MenuId::help,
                .name = "About voxprite",
                .icon = icon::kInfo,
                .run =
                    [](CommandContext& c) {
                        const gl::DriverInfo driver = gl::driverInfo();
                        c.dialogs.showAbout(driver.renderer + "\nOpenGL " + driver.version);
                    }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
