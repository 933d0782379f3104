#include "app/editor/panels/dialogs.h"

#include <cmath>

#include "app/editor/widgets.h"

namespace voxprite::editor {
namespace {

// A modal window in the middle, as high as its content. Call end() when it returned true.
bool begin(Ui& ui, const char* id, const char* title, float width) {
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({std::round(display.x * 0.5f), std::round(display.y * 0.42f)},
                            ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(ui.theme.px(width), display.x - ui.theme.px(32)), 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(24, 20));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.theme.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(8, 8));
    const bool open = ImGui::BeginPopupModal(
        id, nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    if (!open) {
        ImGui::PopStyleVar(3);
        return false;
    }
    ImGui::PushFont(ui.theme.fonts.bold);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    return true;
}

void end() {
    ImGui::EndPopup();
    ImGui::PopStyleVar(3);
}

// Right-aligned row of `count` buttons: puts the cursor where the first one goes.
void placeButtons(Ui& ui, ImVec2 button, int count) {
    ImGui::Dummy(ui.theme.px(0, 8));
    const auto buttons = static_cast<float>(count);
    const float row = buttons * button.x + (buttons - 1.0f) * ui.theme.px(8);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - row);
}

bool pressedKey(ImGuiKey_ key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}

}  // namespace

std::string Dialogs::openName() const {
    if (unsaved_) return "unsaved";
    if (!error_.empty()) return "error";
    return about_ ? "about" : "";
}

UnsavedAnswer Dialogs::draw(Ui& ui) {
    if (!error_.empty()) {
        drawError(ui);
    } else if (unsaved_) {
        return drawUnsaved(ui);
    } else if (about_) {
        drawAbout(ui);
    }
    return UnsavedAnswer::none;
}

UnsavedAnswer Dialogs::drawUnsaved(Ui& ui) {
    if (!begin(ui, "##unsaved", "Save the changes?", 420)) return UnsavedAnswer::none;
    const std::string text = "\"" + ui.session.title() + "\" has changes that are in no file yet.";
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
    if (primaryButton(ui, "Save", button) || pressedKey(ImGuiKey_Enter)) {
        answer = UnsavedAnswer::save;
    }
    ui.probe.markItem("unsaved.save");
    if (answer != UnsavedAnswer::none) {
        unsaved_ = false;
        ImGui::CloseCurrentPopup();
    }
    end();
    return answer;
}

void Dialogs::drawError(Ui& ui) {
    if (!begin(ui, "##error", "That did not work", 480)) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", error_.c_str());
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 1);
    if (primaryButton(ui, "OK", button) || pressedKey(ImGuiKey_Escape) ||
        pressedKey(ImGuiKey_Enter)) {
        error_.clear();
        ImGui::CloseCurrentPopup();
    }
    ui.probe.markItem("error.ok");
    end();
}

void Dialogs::drawAbout(Ui& ui) {
    if (!begin(ui, "##about", "voxprite", 420)) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped(
        "Voxel models for games that show them as outlined pixel art, with the very sprite that "
        "the game will show beside the model.");
    ImGui::Dummy(ui.theme.px(0, 2));
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::TextWrapped("%s", driver_.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 1);
    if (primaryButton(ui, "Close", button) || pressedKey(ImGuiKey_Escape)) {
        about_ = false;
        ImGui::CloseCurrentPopup();
    }
    end();
}

}  // namespace voxprite::editor
