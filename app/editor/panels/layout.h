// Where the parts of the window go. Whole pixels, nothing overlaps, nothing is left over.
#pragma once

#include "app/editor/settings/settings.h"
#include "app/editor/window/theme.h"

namespace voxprite::editor {

struct Area {
    ImVec2 min{0, 0};
    ImVec2 size{0, 0};  // 0: not shown
    [[nodiscard]] ImVec2 max() const { return {min.x + size.x, min.y + size.y}; }
    [[nodiscard]] bool shown() const { return size.x > 0.0f && size.y > 0.0f; }
};

struct Layout {
    Area menu, tools, options, edit, divider, sprite, timeline, status;
    // On the right; the bars are dragged to make room. The dock keeps its tabs when it is folded.
    Area sideBar, inspector, dockBar, dock;
};

// `timelineHeight` in pixels of the strip below both views; 0 for none.
[[nodiscard]] Layout layoutFor(const Theme& theme, ImVec2 window, const WindowSettings& settings,
                               float timelineHeight);

}  // namespace voxprite::editor
