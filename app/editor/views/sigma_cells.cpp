#include "app/editor/views/sigma_cells.h"

#include <cstdio>

#include "app/editor/panels/widgets.h"
#include "app/editor/views/pill.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"
#include "core/model/game_profile.h"

namespace voxprite::editor {
namespace {

void useSigma(Ui& ui, double sigma, bool merge) {
    const GameProfile& before = ui.session.profile();
    GameProfile after = before;
    after.sigma = sigma;
    if (after != before) ui.edits.push("Sigma", ProfileEdit{before, after}, merge);
}

// "6.4 px a vpx", and what minification made of sigma.
std::string detailOf(const SpriteCell& cell, double sigma) {
    std::array<char, 64> text{};
    if (cell.stats.drawn == 0) return {};
    if (cell.stats.sigmaInForce != sigma) {
        std::snprintf(text.data(), text.size(), "drawn at σ %.4g, %.1f px a vpx",
                      cell.stats.sigmaInForce, cell.stats.screenPxPerPx);
    } else {
        std::snprintf(text.data(), text.size(), "%.1f px a vpx", cell.stats.screenPxPerPx);
    }
    return text.data();
}

// The value, and whether it is in force or could be.
void drawCaption(Ui& ui, ImVec2 lowerLeft, int index) {
    const Theme& theme = ui.theme;
    SigmaComparison& comparison = ui.settings.scene.comparison;
    const bool inForce = comparison.inForce == index;
    double& sigma = comparison.sigmas[static_cast<std::size_t>(index)];
    const std::string name = "compare." + std::to_string(index);
    const ImVec2 size = theme.px(166, 30);

    ImGui::SetCursorScreenPos({lowerLeft.x + theme.px(10), lowerLeft.y - size.y - theme.px(10)});
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(8, 3));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(6, 3));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, kPill);
    ImGui::PushStyleColor(ImGuiCol_Text, kPillText);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(255, 255, 255, 26));
    ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, IM_COL32(255, 255, 255, 44));
    ImGui::PushStyleColor(ImGuiCol_FrameBgActive, IM_COL32(255, 255, 255, 60));
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(255, 255, 255, 26));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(255, 255, 255, 44));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, IM_COL32(255, 255, 255, 60));
    ImGui::BeginChild(name.c_str(), size, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.fonts.bold);
    ImGui::TextUnformatted("σ");
    ImGui::PopFont();
    ImGui::SameLine(0.0f, theme.px(6));
    ImGui::SetNextItemWidth(theme.px(54));
    double wanted = sigma;
    const bool changed =
        ImGui::DragScalar("##sigma", ImGuiDataType_Double, &wanted, 0.02f, &kLeastSigma,
                          &kMostSigma, "%.4g", ImGuiSliderFlags_AlwaysClamp);
    ui.edits.watchItem(ui.session);
    ui.probe.markItem(name + ".sigma");
    tooltip(ui, "Drag, or double-click to type");
    if (changed && wanted >= kLeastSigma) {
        sigma = wanted;
        if (inForce) useSigma(ui, wanted, true);
    }
    ImGui::SameLine(0.0f, theme.px(6));
    if (inForce) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme.accent);
        ImGui::Text("%s In force", icon::kCheck);
        ImGui::PopStyleColor();
    } else {
        const float width = ImGui::GetContentRegionAvail().x;
        if (ImGui::Button("Use this", {width, 0})) useSigma(ui, sigma, false);
        ui.probe.markItem(name + ".use");
        tooltip(ui, "Make this the game's sigma");
    }
    ImGui::EndChild();
    ImGui::PopStyleColor(8);
    ImGui::PopStyleVar(3);
}

}  // namespace

void showSigmaCells(Ui& ui, const ViewCanvas& canvas, std::span<const CellArea> areas,
                    std::span<const SpriteCell> cells) {
    const Theme& theme = ui.theme;
    const SigmaComparison& comparison = ui.settings.scene.comparison;
    ImDrawList& draw = canvas.overlay();
    draw.AddRectFilled(canvas.toWindow({0, 0}), canvas.toWindow(glm::dvec2(canvas.sizePx())),
                       theme.window);
    for (std::size_t i = 0; i < std::min(areas.size(), cells.size()); ++i) {
        const SpriteCell& cell = cells[i];
        const ImVec2 min = canvas.toWindow(glm::dvec2(areas[i].min));
        const ImVec2 max = canvas.toWindow(glm::dvec2(areas[i].min + areas[i].size));
        if (cell.frame != nullptr && cell.problem.empty()) {
            // The texture's rows run upward.
            draw.AddImage(imguiTexture(cell.frame->colourTexture()), min, max, {0, 1}, {1, 0});
        }
        const std::string detail =
            cell.problem.empty() ? detailOf(cell, comparison.sigmas[i]) : cell.problem;
        ImFont* small = theme.fonts.small;
        const float wrap = max.x - min.x - theme.px(36);
        const ImVec2 text = small->CalcTextSizeA(small->FontSize, FLT_MAX, wrap, detail.c_str());
        if (!detail.empty()) {
            const ImVec2 at(min.x + theme.px(10), max.y - text.y - theme.px(52));
            draw.AddRectFilled(at, {at.x + text.x + theme.px(16), at.y + text.y + theme.px(8)},
                               kPill, theme.px(6));
            draw.AddText(small, small->FontSize, {at.x + theme.px(8), at.y + theme.px(4)}, kPillDim,
                         detail.c_str(), nullptr, wrap);
        }
        if (comparison.inForce == static_cast<int>(i)) {
            const float width = theme.px(2), half = width * 0.5f;
            draw.AddRect({min.x + half, min.y + half}, {max.x - half, max.y - half}, theme.accent,
                         0.0f, 0, width);
        }
        ui.probe.mark("view.sprite." + std::to_string(i), min, max);
        drawCaption(ui, {min.x, max.y}, static_cast<int>(i));
    }
}

}  // namespace voxprite::editor
