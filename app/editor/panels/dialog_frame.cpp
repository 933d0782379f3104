#include "app/editor/panels/dialog_frame.h"

#include <algorithm>
#include <cmath>

namespace voxprite::editor {

bool beginDialog(Ui& ui, const char* id, const char* title, float width, float height) {
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float air = ui.theme.px(32);
    const ImVec2 size(std::min(ui.theme.px(width), display.x - air),
                      std::min(ui.theme.px(height), display.y - air));
    // Above the middle, but for what is too high for that.
    const float middle = std::max(display.y * 0.46f, (size.y + air) * 0.5f);
    ImGui::SetNextWindowPos({std::round(display.x * 0.5f), std::round(middle)}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
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

void endDialog() {
    ImGui::EndPopup();
    ImGui::PopStyleVar(3);
}

void placeButtons(Ui& ui, ImVec2 button, int count) {
    ImGui::Dummy(ui.theme.px(0, 8));
    const auto buttons = static_cast<float>(count);
    const float row = buttons * button.x + (buttons - 1.0f) * ui.theme.px(8);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - row);
}

bool pressedKey(ImGuiKey_ key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}

bool pressedEnter() {
    return pressedKey(ImGuiKey_Enter) || pressedKey(ImGuiKey_KeyPadEnter);
}

}  // namespace voxprite::editor
