// The tables of commands, one an area of the program, in the order of their menus.
#pragma once

#include <span>

#include "app/editor/commands/commands.h"

namespace voxprite::editor {

// What several tables head their parts of a menu with.
inline constexpr const char* kSpriteViewGroup = "Sprite view";

[[nodiscard]] std::span<const Command> fileCommands();
[[nodiscard]] std::span<const Command> editCommands();
[[nodiscard]] std::span<const Command> clipboardCommands();
[[nodiscard]] std::span<const Command> selectionCommands();
[[nodiscard]] std::span<const Command> objectCommands();
[[nodiscard]] std::span<const Command> animationCommands();
[[nodiscard]] std::span<const Command> toolCommands();
[[nodiscard]] std::span<const Command> toolOptionCommands();
[[nodiscard]] std::span<const Command> paletteCommands();
[[nodiscard]] std::span<const Command> viewCommands();
[[nodiscard]] std::span<const Command> sceneCommands();
[[nodiscard]] std::span<const Command> representationCommands();
[[nodiscard]] std::span<const Command> tradeCommands();
[[nodiscard]] std::span<const Command> helpCommands();

}  // namespace voxprite::editor
