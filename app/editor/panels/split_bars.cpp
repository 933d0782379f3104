#include "app/editor/panels/split_bars.h"

#include <algorithm>

#include "app/editor/panels/panel_area.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

struct Bar {
    bool dragged = false;
    bool folds = false;  // double-clicked
};

// `upright` is one that moves sideways.
Bar drawBar(Ui& ui, const char* name, const Area& area, bool upright, const char* hint) {
    beginPanel(ui, name, area, {0, 0},
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("drag", area.size);
    Bar bar;
    bar.folds = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    bar.dragged = ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f);
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) {
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    }
    if (hint != nullptr && !ImGui::IsItemActive()) tooltip(ui, hint);
    const ImVec2 middle(std::floor(area.min.x + area.size.x * 0.5f),
                        std::floor(area.min.y + area.size.y * 0.5f));
    const float half = ui.theme.px(16);
    const ImVec2 along = upright ? ImVec2(0, half) : ImVec2(half, 0);
    ImGui::GetWindowDrawList()->AddLine(
        {middle.x - along.x, middle.y - along.y}, {middle.x + along.x, middle.y + along.y},
        lit ? ui.theme.accent : ui.theme.fieldActive, ui.theme.px(2));
    ImGui::End();
    return bar;
}

}  // namespace

void drawSplitBars(Ui& ui, const Layout& layout) {
    WindowSettings& window = ui.settings.window;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float scale = ui.theme.scale;
    if (drawBar(ui, "panel.divider", layout.divider, true, nullptr).dragged) {
        const float views = layout.sprite.max().x - layout.edit.min.x;
        window.split = std::clamp((mouse.x - layout.edit.min.x) / views, 0.15f, 0.85f);
    }
    const Bar side = drawBar(ui, "panel.sideBar", layout.sideBar, true,
                             window.showsSide ? nullptr : "Double-click for the side panels (Tab)");
    if (side.folds) {
        window.showsSide = !window.showsSide;
    } else if (side.dragged && window.showsSide) {
        const float right = layout.sideBar.max().x + layout.inspector.size.x;
        window.sideWidth = std::clamp((right - mouse.x) / scale, kLeastSide, kMostSide);
    }
    if (!window.showsSide) return;
    const Bar dock = drawBar(ui, "panel.dockBar", layout.dockBar, false, nullptr);
    if (dock.folds) {
        window.showsDock = !window.showsDock;
    } else if (dock.dragged && window.showsDock) {
        const float height = layout.dock.max().y - layout.inspector.min.y;
        window.dockShare =
            std::clamp((layout.dock.max().y - mouse.y) / height, kLeastDock, kMostDock);
    }
}

}  // namespace voxprite::editor
