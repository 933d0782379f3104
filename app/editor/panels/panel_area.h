// A part of the window as a panel.
#pragma once

#include "app/editor/panels/layout.h"
#include "app/editor/panels/ui.h"

namespace voxprite::editor {

// Fills `area`. Always ends with ImGui::End().
void beginPanel(Ui& ui, const char* name, const Area& area, ImVec2 padding,
                ImGuiWindowFlags more = 0);

}  // namespace voxprite::editor
