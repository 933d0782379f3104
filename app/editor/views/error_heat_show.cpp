// The error map over the view, and its legend.
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "app/editor/panels/trade_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/views/error_heat.h"
#include "app/editor/views/heat_ramp.h"
#include "app/editor/views/pill.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr std::array kHeatYardsticks{
    Choice{"Exact view",
           "The exact sprite of this very view at its own sigma: shows what view "
           "step, region and stand-ins cost"},
    Choice{"Reference", "The exact sprite of this view by the reference of the Trade panel"},
    Choice{"Voxels",
           "The voxels themselves in perspective, a ray a screen pixel: shows what the "
           "style leaves out, too"}};

float widthOf(const ImFont& font, const std::string& text) {
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.c_str()).x;
}

// A mark on the colour bar, above or below it.
void mark(ImDrawList& draw, float x, float edge, float size, ImU32 colour) {
    draw.AddTriangleFilled({x, edge}, {x - std::abs(size), edge - size * 1.4f},
                           {x + std::abs(size), edge - size * 1.4f}, colour);
}

// 0 ... 100 %, with the mean above and what lies under the pointer below.
void drawBar(const Theme& theme, ImVec2 min, float width, std::optional<double> mean,
             std::optional<double> under) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float height = theme.px(10);
    constexpr int kParts = 64;
    for (int k = 0; k < kParts; ++k) {
        const float from = min.x + width * static_cast<float>(k) / kParts;
        const float to = min.x + width * static_cast<float>(k + 1) / kParts;
        const ImU32 left = toImU32(heatColour(static_cast<double>(k) / kParts));
        const ImU32 right = toImU32(heatColour(static_cast<double>(k + 1) / kParts));
        draw.AddRectFilledMultiColor({std::round(from), min.y}, {std::round(to), min.y + height},
                                     left, right, right, left);
    }
    draw.AddRect({min.x - 1, min.y - 1}, {min.x + width + 1, min.y + height + 1},
                 IM_COL32(255, 255, 255, 56));
    const auto at = [&](double error) {
        return std::round(min.x + width * static_cast<float>(std::clamp(error, 0.0, 1.0)));
    };
    if (mean) mark(draw, at(*mean), min.y - theme.px(1), theme.px(4), kPillText);
    ImFont* small = theme.fonts.small;
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const std::string text = std::to_string(25 * quarter) + (quarter == 4 ? " %" : "");
        const float x = at(0.25 * quarter);
        draw.AddLine({x, min.y + height}, {x, min.y + height + theme.px(3)},
                     IM_COL32(255, 255, 255, 90));
        const float wide = widthOf(*small, text);
        const float left = quarter == 0   ? min.x
                           : quarter == 4 ? min.x + width - wide
                                          : x - std::round(wide * 0.5f);
        draw.AddText(small, small->FontSize, {left, min.y + height + theme.px(4)}, kPillDim,
                     text.c_str());
    }
    if (under) mark(draw, at(*under), min.y + height + theme.px(1), -theme.px(4), kPillText);
}

}  // namespace

void ErrorHeat::show(Ui& ui, const ViewCanvas& canvas, glm::dvec2 pointerPx) const {
    const Theme& theme = ui.theme;
    ImDrawList& draw = canvas.overlay();
    // Where nothing is wrong there is nothing to cover.
    if (map_ && !map_->equal) {
        const glm::ivec2 size(map_->image.width, map_->image.height);
        draw.AddImage(imguiTexture(texture_.id()), canvas.toWindow(glm::dvec2(map_->min)),
                      canvas.toWindow(glm::dvec2(map_->min + size)));
    }
    const float pad = theme.px(10);
    const ImVec2 size(std::min(theme.px(264), static_cast<float>(canvas.sizePx().x) - 2 * pad),
                      theme.px(104));
    const ImVec2 corner = canvas.toWindow(glm::dvec2(canvas.sizePx()));
    const ImVec2 at(corner.x - size.x - pad, corner.y - size.y - pad);
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(12), theme.px(8)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, kPill);
    ImGui::BeginChild("sprite.heat", size, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    ImFont *bold = theme.fonts.bold, *small = theme.fonts.small;
    ImDrawList& own = *ImGui::GetWindowDrawList();
    const float left = at.x + theme.px(12), right = at.x + size.x - theme.px(12);
    own.AddText(bold, bold->FontSize, {left, at.y + theme.px(8)}, kPillText, "Error");
    ImGui::SetCursorScreenPos({left, at.y + theme.px(6)});
    ImGui::Dummy({right - left, theme.px(22)});
    tooltip(ui, "FLIP: what somebody sees who flips between the two pictures");
    std::string figure = "…";
    std::optional<double> mean, under;
    if (map_) {
        mean = map_->mean;
        under = map_->at(glm::ivec2(glm::floor(pointerPx)));
        figure = map_->equal ? "equal, pixel for pixel" : percentText(map_->mean) + " on average";
        if (under)
            figure = percentText(*under) + " here, " + percentText(map_->mean) + " on average";
    } else if (failed_) {
        figure = "cannot be measured";
    }
    own.AddText(small, small->FontSize, {right - widthOf(*small, figure), at.y + theme.px(9)},
                kPillDim, figure.c_str());
    ui.probe.mark("sprite.heat.mean", {left, at.y + theme.px(8)}, {right, at.y + theme.px(26)});
    drawBar(theme, {left, at.y + theme.px(36)}, right - left, mean, under);
    ImGui::SetCursorScreenPos({left, at.y + theme.px(72)});
    static_cast<void>(enumRow(ui, "sprite.heat.yardstick", nullptr, ui.settings.trade.heatYardstick,
                              kHeatYardsticks));
    ImGui::EndChild();
    ui.probe.mark("sprite.heat", at, {at.x + size.x, at.y + size.y});
}

}  // namespace voxprite::editor
