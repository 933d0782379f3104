// The steps that can be undone and redone, newest at the bottom; a click goes there.
#include <cmath>

#include "app/editor/panels/number_text.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
namespace {

std::uint64_t voxelsOf(const Action& step) {
    std::uint64_t count = 0;
    for (const ActionPart& part : step.parts) {
        if (const auto* patch = std::get_if<VoxelPatch>(&part)) count += patch->changes.size();
    }
    return count;
}

// At the right end of the row that was drawn last: how many voxels a step changed.
void drawCount(Ui& ui, std::uint64_t voxels) {
    if (voxels == 0) return;
    const std::string text = grouped(voxels);
    const ImFont& font = *ui.theme.fonts.small;
    const float width = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.c_str()).x;
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddText(
        &font, font.FontSize,
        {max.x - width - ui.theme.px(10), std::round((min.y + max.y - font.FontSize) * 0.5f)},
        ui.theme.textFaint, text.c_str());
    tooltip(ui, (text + (voxels == 1 ? " voxel" : " voxels") + " changed").c_str());
}

}  // namespace

void askForStep(CommandQueue& commands, std::size_t position, std::size_t wanted) {
    // A long way goes on over many frames: what is left of one gives way to the next.
    using enum CommandId;
    for (const CommandId id : {dropMade, undo, redo}) commands.forget(id);
    // Else the first undo would be for what is only being made.
    if (position > wanted) commands.ask(dropMade);
    for (std::size_t at = position; at > wanted; --at) commands.ask(undo);
    for (std::size_t at = position; at < wanted; ++at) commands.ask(redo);
}

void drawHistory(Ui& ui) {
    const History& history = ui.session.history();
    const auto& steps = history.steps();
    const std::size_t position = history.position();
    const auto goTo = [&](std::size_t wanted) { askForStep(ui.commands, position, wanted); };
    const std::string held =
        byteText(history.bytes()) + " held, of at most " + byteText(history.memoryLimitBytes());
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::TextUnformatted(held.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
    tooltip(ui,
            "What undo and redo hold in memory. The oldest steps go first; the limit is in the "
            "preferences.");
    ImGui::BeginChild("steps");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
    const ImVec2 row(0.0f, ui.theme.px(22));
    // Where there are steps the oldest ones may be gone.
    const char* start = steps.empty() ? "  As opened" : "  Before these steps";
    if (textSelectable(start, position == 0, row)) goTo(0);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(steps.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const bool undone = index >= position;
            if (undone) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textFaint);
            ImGui::PushID(i);
            const std::string label = "  " + steps[index].label;
            if (textSelectable(label, index + 1 == position, row)) goTo(index + 1);
            drawCount(ui, voxelsOf(steps[index]));
            ImGui::PopID();
            if (undone) ImGui::PopStyleColor();
        }
    }
    ImGui::PopStyleVar(2);
    ImGui::EndChild();
}

}  // namespace voxprite::editor
