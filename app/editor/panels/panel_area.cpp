#include "app/editor/panels/panel_area.h"

namespace voxprite::editor {

void beginPanel(Ui& ui, const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags more) {
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings;
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr, kFlags | more);
    ImGui::PopStyleVar(2);
    ui.probe.mark(name, area.min, area.max());
}

}  // namespace voxprite::editor
