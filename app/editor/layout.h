// Where the parts of the window go. Whole pixels, nothing overlaps, nothing is left over.
#pragma once

#include "app/editor/theme.h"

namespace voxprite::editor {

struct Area {
    ImVec2 min{0, 0};
    ImVec2 size{0, 0};
    [[nodiscard]] ImVec2 max() const { return {min.x + size.x, min.y + size.y}; }
};

struct Layout {
    Area menu, tools, options, edit, divider, sprite, inspector, dock, status;
};

// `split` is the edit view's share of the two views.
[[nodiscard]] Layout layoutFor(const Theme& theme, ImVec2 window, float split);

}  // namespace voxprite::editor
