// The tabs of the lists below the inspector; they stay when the lists are folded.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

void tab(Ui& ui, const char* name, bool on, DockTab value) {
    const Theme& theme = ui.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 text = ImGui::CalcTextSize(name);
    const ImVec2 size(text.x + theme.px(2), theme.px(28));
    ImGui::PushID(name);
    if (ImGui::InvisibleButton("tab", size)) ui.settings.window.show(value);
    ImGui::PopID();
    ui.probe.markItem(std::string("dock.") + name);
    const ImU32 colour = on || ImGui::IsItemHovered() ? theme.text : theme.textDim;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(theme.fonts.bold, theme.fonts.bold->FontSize, {at.x, at.y + theme.px(5)}, colour,
                 name);
    if (on) {
        draw.AddRectFilled({at.x, at.y + size.y - theme.px(2)}, {at.x + size.x, at.y + size.y},
                           theme.accent);
    }
}

}  // namespace

bool drawDockTabs(Ui& ui) {
    constexpr std::array<const char*, 5> kTabs{"Palette", "Objects", "History", "Scene", "Trade"};
    WindowSettings& window = ui.settings.window;
    const float square = ui.theme.px(24);
    // As far apart as there is room.
    float names = 0.0f;
    for (const char* name : kTabs) names += ImGui::CalcTextSize(name).x + ui.theme.px(2);
    const float spare = ImGui::GetWindowContentRegionWidth() - names - square;
    const float gap = std::clamp(std::floor(spare / static_cast<float>(kTabs.size())),
                                 ui.theme.px(4), ui.theme.px(18));
    for (std::size_t i = 0; i < kTabs.size(); ++i) {
        const auto value = static_cast<DockTab>(i);
        tab(ui, kTabs[i], window.showsDock && window.dockTab == value, value);
        ImGui::SameLine(0.0f, gap);
    }
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - square);
    if (iconButton(ui, "dock.fold", window.showsDock ? icon::kDown : icon::kUpChevron, Lit::off,
                   square, window.showsDock ? "Fold" : "Unfold")) {
        window.showsDock = !window.showsDock;
    }
    return window.showsDock;
}

}  // namespace voxprite::editor
