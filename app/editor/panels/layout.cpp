#include "app/editor/panels/layout.h"

#include <algorithm>

namespace voxprite::editor {
namespace {

// What the side panels leave for the views, and the inspector for the dock.
constexpr float kLeastViews = 200.0f, kLeastPanel = 60.0f;
constexpr float kFoldedDock = 40.0f;

void placeSide(Layout& layout, const Theme& theme, const WindowSettings& settings, Area side) {
    const float bar = theme.px(5);
    float dock = theme.px(kFoldedDock);
    if (settings.showsDock) {
        const float most = side.size.y - bar - theme.px(kLeastPanel);
        dock = std::clamp(std::round(side.size.y * settings.dockShare), dock, std::max(dock, most));
    }
    dock = std::min(dock, std::max(1.0f, side.size.y - bar - 1.0f));
    const float inspector = std::max(1.0f, side.size.y - dock - bar);
    layout.inspector = {side.min, {side.size.x, inspector}};
    layout.dockBar = {{side.min.x, side.min.y + inspector}, {side.size.x, bar}};
    layout.dock = {{side.min.x, side.min.y + inspector + bar}, {side.size.x, dock}};
}

}  // namespace

Layout layoutFor(const Theme& theme, ImVec2 window, const WindowSettings& settings,
                 float timelineHeight) {
    const float menuHeight = theme.px(30), statusHeight = theme.px(26);
    const float line = std::max(1.0f, theme.px(1)), bar = theme.px(5);
    const float top = menuHeight + line;
    const float height = std::max(8.0f, window.y - top - statusHeight - line);

    Layout layout;
    layout.menu = {{0, 0}, {window.x, menuHeight}};
    layout.status = {{0, window.y - statusHeight}, {window.x, statusHeight}};
    const float toolWidth = settings.showsTools ? theme.px(84) : 0.0f;
    if (settings.showsTools) layout.tools = {{0, top}, {toolWidth, height}};
    const float viewsLeft = settings.showsTools ? toolWidth + line : 0.0f;

    const float room = window.x - viewsLeft - bar - theme.px(kLeastViews);
    float side = settings.showsSide ? theme.px(settings.sideWidth) : 0.0f;
    side = std::min(side, std::max(settings.showsSide ? 1.0f : 0.0f, room));
    const float viewsWidth = std::max(3.0f + bar, window.x - viewsLeft - bar - side);
    layout.sideBar = {{viewsLeft + viewsWidth, top}, {bar, height}};
    if (settings.showsSide) {
        placeSide(layout, theme, settings, {{viewsLeft + viewsWidth + bar, top}, {side, height}});
    }

    // The options of the tool in hand run along the top of both views, the timeline below them.
    const float options = theme.px(36);
    layout.options = {{viewsLeft, top}, {viewsWidth, options}};
    const float viewTop = top + options + line;
    float viewHeight = std::max(1.0f, height - options - line);
    const float strip = std::min(std::round(timelineHeight), std::max(0.0f, viewHeight - line - 1));
    if (strip > 0.0f) {
        viewHeight -= strip + line;
        layout.timeline = {{viewsLeft, viewTop + viewHeight + line}, {viewsWidth, strip}};
    }
    const float edit =
        std::clamp(std::round((viewsWidth - bar) * settings.split), 1.0f, viewsWidth - bar - 1);
    layout.edit = {{viewsLeft, viewTop}, {edit, viewHeight}};
    layout.divider = {{viewsLeft + edit, viewTop}, {bar, viewHeight}};
    layout.sprite = {{viewsLeft + edit + bar, viewTop}, {viewsWidth - edit - bar, viewHeight}};
    return layout;
}

}  // namespace voxprite::editor
