// The steps that can be undone and redone, newest at the bottom; a click goes there.
#include "app/editor/panels/number_text.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {

void drawHistory(Ui& ui) {
    const History& history = ui.session.history();
    const auto& steps = history.steps();
    const std::size_t position = history.position();
    const auto goTo = [&](std::size_t wanted) {
        for (std::size_t at = position; at > wanted; --at) ui.commands.ask(CommandId::undo);
        for (std::size_t at = position; at < wanted; ++at) ui.commands.ask(CommandId::redo);
    };
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
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(0, 4));
    if (ImGui::Selectable("  As opened", position == 0)) goTo(0);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(steps.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const bool undone = index >= position;
            if (undone) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textFaint);
            ImGui::PushID(i);
            const std::string label = "  " + steps[index].label;
            if (ImGui::Selectable(label.c_str(), index + 1 == position)) goTo(index + 1);
            ImGui::PopID();
            if (undone) ImGui::PopStyleColor();
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace voxprite::editor
