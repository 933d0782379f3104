#include "app/editor/panels/sheet_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

// So many pixels of the window a pixel of the sheet. Whole ones where it is enlarged.
float scaleOf(const SheetPictureArea& area, float air, glm::vec2 sheetPx) {
    const float fits =
        std::min((area.size.x - 2 * air) / sheetPx.x, (area.size.y - 2 * air) / sheetPx.y);
    const float scale = fits * area.zoom;
    return scale >= 1.0f ? std::floor(scale) : scale;
}

void drawCheckerboard(ImDrawList& draw, const Theme& theme, ImVec2 min, ImVec2 max) {
    const float edge = theme.px(8);
    const bool dark = theme.kind == ThemeKind::dark;
    draw.AddRectFilled(min, max, dark ? IM_COL32(52, 54, 58, 255) : IM_COL32(236, 237, 240, 255));
    const ImU32 other = dark ? IM_COL32(62, 64, 69, 255) : IM_COL32(220, 222, 226, 255);
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    const auto first = [&](float from, float clip) {
        return std::max(0, static_cast<int>((clip - from) / edge));
    };
    for (int row = first(min.y, low.y); min.y + static_cast<float>(row) * edge < max.y; ++row) {
        const float y = min.y + static_cast<float>(row) * edge;
        if (y > high.y) break;
        for (int column = first(min.x, low.x) & ~1;; column += 2) {
            const float x = min.x + static_cast<float>(column + row % 2) * edge;
            if (x >= max.x || x > high.x) break;
            draw.AddRectFilled({x, y}, {std::min(x + edge, max.x), std::min(y + edge, max.y)},
                               other);
        }
    }
}

std::string spriteNameOf(const SheetSprite& sprite) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "Direction %d (%.4g°), pitch %.4g°, frame %d",
                  sprite.direction, sprite.yawDegrees, sprite.pitchDegrees, sprite.frame);
    return text.data();
}

void drawHovered(Ui& ui, const Sheet& sheet, ImVec2 min, float scale) {
    const Theme& theme = ui.theme;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::ivec2 at(std::floor((mouse.x - min.x) / scale),
                        std::floor((mouse.y - min.y) / scale));
    const SheetSprite* under = nullptr;
    int same = 0;  // equal sprites share a place
    for (const SheetSprite& sprite : sheet.sprites) {
        const glm::ivec2 in = at - sprite.at;
        if (in.x < 0 || in.y < 0 || in.x >= sprite.size.x || in.y >= sprite.size.y) continue;
        if (under == nullptr) under = &sprite;
        ++same;
    }
    if (under == nullptr) return;
    const ImVec2 low(min.x + static_cast<float>(under->at.x) * scale,
                     min.y + static_cast<float>(under->at.y) * scale);
    ImGui::GetWindowDrawList()->AddRect(low,
                                        {low.x + static_cast<float>(under->size.x) * scale,
                                         low.y + static_cast<float>(under->size.y) * scale},
                                        theme.accent, 0.0f, 0, theme.px(2));
    std::string text = spriteNameOf(*under);
    if (same > 1) text += "\nand " + std::to_string(same - 1) + " that look the same";
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(10, 7));
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(text.c_str());
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

}  // namespace

void drawSheetPicture(Ui& ui, const SheetPictureArea& area, ImVec2& pan) {
    const Image& image = area.sheet.pictures.front().image;
    const glm::vec2 sheetPx(image.width, image.height);
    const float air = ui.theme.px(16);
    const float scale = scaleOf(area, air, sheetPx);
    const ImVec2 extent(sheetPx.x * scale, sheetPx.y * scale);
    const auto kept = [&](float value, float whole, float room) {
        const float reach = std::max(0.0f, (whole - room) * 0.5f + air);
        return std::clamp(value, -reach, reach);
    };
    pan = {kept(pan.x, extent.x, area.size.x), kept(pan.y, extent.y, area.size.y)};
    const ImVec2 min(std::round(area.corner.x + (area.size.x - extent.x) * 0.5f + pan.x),
                     std::round(area.corner.y + (area.size.y - extent.y) * 0.5f + pan.y));
    const ImVec2 max(min.x + extent.x, min.y + extent.y);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    drawCheckerboard(draw, ui.theme, min, max);
    draw.AddImage(imguiTexture(area.picture.id()), min, max);
    draw.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, ui.theme.line);
    if (area.hovered) drawHovered(ui, area.sheet, min, scale);
}

}  // namespace voxprite::editor
