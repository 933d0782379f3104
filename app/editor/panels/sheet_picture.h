// A packed sheet as the dialog shows it: as large as fits, over a checkerboard, and what the sprite
// under the pointer is.
#pragma once

#include "app/editor/panels/ui.h"
#include "core/sheet/sheet.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

struct SheetPictureArea {
    const Sheet& sheet;
    const PictureTexture& picture;
    ImVec2 corner, size;  // of the area, window pixels
    float zoom = 1.0f;    // on top of what fits
    bool hovered = false;
};
// `pan`, window pixels from the middle, is kept so that the picture never leaves the area.
void drawSheetPicture(Ui& ui, const SheetPictureArea& area, ImVec2& pan);

}  // namespace voxprite::editor
