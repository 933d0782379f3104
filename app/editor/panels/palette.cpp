// The palette: 16 columns of swatches in the file's display order, and the colour in hand.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets.h"

namespace voxprite::editor {
namespace {

constexpr int kColumns = 16;
constexpr int kRows = 16;

ImU32 imColour(Rgba8 colour) {
    return IM_COL32(colour.x, colour.y, colour.z, 255);
}

// The colour in hand: its swatch, its place in the palette, its channels.
void drawCurrent(Ui& ui) {
    const Theme& theme = ui.theme;
    const Palette& palette = ui.session.document().palette;
    const std::uint8_t index = ui.settings.tool.colour;
    const Rgba8 colour = palette.colours[index];
    float rgb[3] = {static_cast<float>(colour.x) / 255.0f, static_cast<float>(colour.y) / 255.0f,
                    static_cast<float>(colour.z) / 255.0f};
    ImGui::AlignTextToFramePadding();
    const std::string label = "#" + std::to_string(index);
    ImGui::TextUnformatted(label.c_str());
    ImGui::SameLine(theme.px(44), 0.0f);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool changed = ImGui::ColorEdit3("##colour", rgb, ImGuiColorEditFlags_DisplayHex);
    ui.edits.watchItem(ui.session);
    ui.probe.markItem("palette.edit");
    if (!changed) return;
    Palette after = palette;
    const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(c * 255.0f)); };
    after.colours[index] = Rgba8(byte(rgb[0]), byte(rgb[1]), byte(rgb[2]), colour.w);
    ui.edits.push("Palette colour", PaletteEdit{palette, after});
}

}  // namespace

void drawPalette(Ui& ui) {
    const Theme& theme = ui.theme;
    const Palette& palette = ui.session.document().palette;
    drawCurrent(ui);

    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    // Square where there is room, flatter where there is not.
    const float width = std::floor(space.x / kColumns);
    const float height = std::clamp(std::floor(space.y / kRows), theme.px(8), width);
    ImGui::InvisibleButton("swatches", {width * kColumns, height * kRows});
    ui.probe.markItem("palette.swatches");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float gap = std::max(1.0f, theme.px(1));
    for (int slot = 0; slot < kColumns * kRows; ++slot) {
        const std::uint8_t index = palette.displayOrder[static_cast<std::size_t>(slot)];
        const ImVec2 min(corner.x + width * static_cast<float>(slot % kColumns),
                         corner.y + height * static_cast<float>(slot / kColumns));
        const ImVec2 max(min.x + width - gap, min.y + height - gap);
        if (index == 0) {  // empty: a cross, not a colour
            draw.AddRect(min, max, theme.line);
            continue;
        }
        draw.AddRectFilled(min, max, imColour(palette.colours[index]), theme.px(2));
        const bool under = hovered && mouse.x >= min.x && mouse.x < min.x + width &&
                           mouse.y >= min.y && mouse.y < min.y + height;
        if (under) {
            if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) ui.settings.tool.colour = index;
            const std::string& name = palette.names[index];
            tooltip(ui, name.empty() ? ("#" + std::to_string(index)).c_str()
                                     : ("#" + std::to_string(index) + "  " + name).c_str());
        }
        if (index == ui.settings.tool.colour) {
            draw.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, theme.panel, theme.px(3),
                         0, theme.px(4));
            draw.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, theme.text, theme.px(3), 0,
                         theme.px(2));
        }
    }
}

}  // namespace voxprite::editor
