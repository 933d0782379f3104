// What is behind the voxels in the edit view.
#pragma once

#include "app/editor/settings/settings.h"
#include "core/model/palette.h"

namespace voxprite::editor {

struct BackdropColours {
    Rgba8 top, bottom;
    Rgba8 ink;  // for thin lines over it
};

[[nodiscard]] BackdropColours backdropColours(Backdrop backdrop, ThemeKind theme);

}  // namespace voxprite::editor
