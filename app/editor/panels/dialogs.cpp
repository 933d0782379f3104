#include "app/editor/panels/dialogs.h"

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"

namespace voxprite::editor {
std::string Dialogs::openName() const {
    if (!unsaved_.empty()) return "unsaved";
    if (!changed_.empty()) return "changed";
    if (!error_.empty()) return "error";
    return about_.empty() ? "" : "about";
}

Answers Dialogs::draw(Ui& ui) {
    Answers answers;
    if (!error_.empty()) {
        drawError(ui);
    } else if (!unsaved_.empty()) {
        answers.unsaved = drawUnsaved(ui);
    } else if (!changed_.empty()) {
        answers.changed = drawChanged(ui);
    } else if (!about_.empty()) {
        drawAbout(ui);
    }
    return answers;
}

UnsavedAnswer Dialogs::drawUnsaved(Ui& ui) {
    if (!beginDialog(ui, "##unsaved", question_.c_str(), 420)) return UnsavedAnswer::none;
    const std::string text = unsaved_ + " has changes that are in no file yet.";
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 3);
    UnsavedAnswer answer = UnsavedAnswer::none;
    if (ImGui::Button("Discard", button)) answer = UnsavedAnswer::discard;
    ui.probe.markItem("unsaved.discard");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", button) || pressedKey(ImGuiKey_Escape)) {
        answer = UnsavedAnswer::cancel;
    }
    ui.probe.markItem("unsaved.cancel");
    ImGui::SameLine();
    if (primaryButton(ui, "Save", button) || pressedEnter()) {
        answer = UnsavedAnswer::save;
    }
    ui.probe.markItem("unsaved.save");
    if (answer != UnsavedAnswer::none) {
        unsaved_.clear();
        ImGui::CloseCurrentPopup();
    }
    endDialog();
    return answer;
}

ChangedAnswer Dialogs::drawChanged(Ui& ui) {
    if (!beginDialog(ui, "##changed", "Replace the file?", 460)) return ChangedAnswer::none;
    const std::string text = changed_ +
                             " was changed by another program since it was opened or saved here. "
                             "What it wrote would be lost.";
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 3);
    ChangedAnswer answer = ChangedAnswer::none;
    if (ImGui::Button("Replace it", button)) answer = ChangedAnswer::replace;
    ui.probe.markItem("changed.replace");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", button) || pressedKey(ImGuiKey_Escape)) {
        answer = ChangedAnswer::cancel;
    }
    ui.probe.markItem("changed.cancel");
    ImGui::SameLine();
    if (primaryButton(ui, "Save as...", button) || pressedEnter()) {
        answer = ChangedAnswer::saveAs;
    }
    ui.probe.markItem("changed.saveAs");
    if (answer != ChangedAnswer::none) {
        changed_.clear();
        ImGui::CloseCurrentPopup();
    }
    endDialog();
    return answer;
}

void Dialogs::drawError(Ui& ui) {
    if (!beginDialog(ui, "##error", "That did not work", 480)) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", error_.c_str());
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 1);
    if (primaryButton(ui, "OK", button) || pressedKey(ImGuiKey_Escape) || pressedEnter()) {
        error_.clear();
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("error.ok");
    endDialog();
}

void Dialogs::drawAbout(Ui& ui) {
    if (!beginDialog(ui, "##about", "voxprite", 460)) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped(
        "Voxel models for games that show them as outlined pixel art, with the very sprite that "
        "the game will show beside the model.");
    ImGui::Dummy(ui.theme.px(0, 2));
    ImGui::PushFont(ui.theme.fonts.small);
    for (const AboutLine& line : about_) {
        ImGui::TextUnformatted(line.name.c_str());
        ImGui::SameLine(ui.theme.px(132));
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.text);
        ImGui::TextWrapped("%s", line.value.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 2);
    if (ImGui::Button("Copy", button)) {
        std::string text;
        for (const AboutLine& line : about_) text += line.name + ": " + line.value + "\n";
        ImGui::SetClipboardText(text.c_str());
    }
    tooltip(ui, "For a report of a fault");
    ImGui::SameLine();
    if (primaryButton(ui, "Close", button) || pressedKey(ImGuiKey_Escape)) {
        about_.clear();
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("about.close");
    endDialog();
}

}  // namespace voxprite::editor
