// A small picture in a list: on a tile of its own, its pixels whole.
#pragma once

#include "app/editor/window/theme.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

// A square of `edge` screen pixels at `corner`, the picture in its middle: each of its pixels as
// many whole screen pixels as there is room for, but for pictures that are larger than the tile.
void drawPictureTile(const Theme& theme, ImVec2 corner, float edge, const PictureTexture& picture);

}  // namespace voxprite::editor
