// One line of figures at the bottom.
#include <array>
#include <cstdarg>
#include <cstdio>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
    std::array<char, 160> buffer{};
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
    va_end(arguments);
    return buffer.data();
}

void figure(Ui& ui, const char* name, const std::string& text, const char* hint) {
    ImGui::TextUnformatted(text.c_str());
    ui.probe.markItem(name);
    tooltip(ui, hint);
    ImGui::SameLine(0.0f, ui.theme.px(20));
}

}  // namespace

void drawStatusBar(Ui& ui) {
    const ViewFigures& figures = ui.figures;
    const IBox& bounds = ui.session.bounds();
    const glm::ivec3 size = bounds.empty() ? glm::ivec3(0) : bounds.size();
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    figure(ui, "status.size", format("%d × %d × %d", size.x, size.y, size.z),
           "Size of the model in voxels, all frames together");
    figure(ui, "status.voxels", grouped(ui.session.octree().solidCount()) + " voxels",
           "Solid voxels of the frame shown");
    figure(ui, "status.octree", byteText(ui.session.octree().bytes()) + " octree",
           "Memory of the live octree");
    if (figures.sigmaInForce > 0.0) {
        figure(ui, "status.sigma", format("σ %.4g in force", figures.sigmaInForce),
               "Virtual pixels a voxel as drawn, after minification");
        figure(ui, "status.density", format("%.1f screen px a vpx", figures.screenPxPerPx),
               "Screen pixels that one virtual pixel covers");
    }
    if (figures.editMilliseconds) {
        figure(ui, "status.edit", format("edit %.1f ms", *figures.editMilliseconds),
               "From the last click to both views showing it");
    }
    if (!figures.strokeSize.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.accent);
        figure(ui, "status.stroke", figures.strokeSize, "Size of the box being drawn");
        ImGui::PopStyleColor();
    }
    if (figures.hovered) {
        const glm::ivec3 v = *figures.hovered;
        const std::string place = format("%d, %d, %d", v.x, v.y, v.z);
        const float width = ImGui::CalcTextSize(place.c_str()).x;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width, 0.0f);
        ImGui::TextUnformatted(place.c_str());
        ui.probe.markItem("status.hovered");
        tooltip(ui, "The voxel under the pointer");
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace voxprite::editor
