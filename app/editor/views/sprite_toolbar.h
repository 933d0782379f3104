// The buttons in the upper right corner of the sprite view, and the figures of a crowd at its lower
// edge.
#pragma once

#include "app/editor/views/view_canvas.h"

namespace voxprite::editor {

// Between the canvas' begin() and end().
void drawSpriteToolbar(Ui& ui, const ViewCanvas& canvas);
// Where it begins, in the window, with a gap before it.
[[nodiscard]] float leftOfSpriteToolbar(const Theme& theme, const ViewCanvas& canvas);

}  // namespace voxprite::editor
