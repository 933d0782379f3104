#include "app/editor/layout.h"

#include <algorithm>

namespace voxprite::editor {

Layout layoutFor(const Theme& theme, ImVec2 window, float split) {
    const float menuHeight = theme.px(30), statusHeight = theme.px(26);
    const float toolWidth = theme.px(84), sideWidth = theme.px(320);
    const float line = std::max(1.0f, theme.px(1)), dividerWidth = theme.px(5);
    const float top = menuHeight + line;
    const float height = std::max(1.0f, window.y - top - statusHeight - line);
    const float viewsLeft = toolWidth + line;
    const float viewsWidth = std::max(2.0f + dividerWidth, window.x - viewsLeft - sideWidth - line);
    const float editWidth = std::clamp(std::round((viewsWidth - dividerWidth) * split), 1.0f,
                                       viewsWidth - dividerWidth - 1);
    const float sideLeft = viewsLeft + viewsWidth + line;
    // The palette's swatches are square where the window is high enough.
    const float dockHeight = std::round(std::clamp(height * 0.4f, theme.px(200), theme.px(372)));

    Layout layout;
    layout.menu = {{0, 0}, {window.x, menuHeight}};
    layout.tools = {{0, top}, {toolWidth, height}};
    // The options of the tool in hand run along the top of both views.
    const float optionsHeight = theme.px(36);
    layout.options = {{viewsLeft, top}, {viewsWidth, optionsHeight}};
    const float viewTop = top + optionsHeight + line;
    const float viewHeight = std::max(1.0f, height - optionsHeight - line);
    layout.edit = {{viewsLeft, viewTop}, {editWidth, viewHeight}};
    layout.divider = {{viewsLeft + editWidth, viewTop}, {dividerWidth, viewHeight}};
    const float spriteLeft = viewsLeft + editWidth + dividerWidth;
    layout.sprite = {{spriteLeft, viewTop}, {viewsWidth - editWidth - dividerWidth, viewHeight}};
    layout.inspector = {{sideLeft, top}, {sideWidth, height - dockHeight - line}};
    layout.dock = {{sideLeft, top + height - dockHeight}, {sideWidth, dockHeight}};
    layout.status = {{0, window.y - statusHeight}, {window.x, statusHeight}};
    return layout;
}

}  // namespace voxprite::editor
