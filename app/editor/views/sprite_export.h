// The sprite of the sprite view, out of the program with one key.
#pragma once

#include "app/editor/commands/command_context.h"

namespace voxprite::editor {

// Beside the document (or where files were last), as "knight.png", "knight-2.png", ...: nothing is
// overwritten.
void saveSpritePicture(CommandContext& context);
void copySpritePicture(CommandContext& context);

}  // namespace voxprite::editor
