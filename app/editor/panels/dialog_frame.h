// The look that all dialogs share: a card in the middle of the window, everything else dimmed.
#pragma once

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

// `heightPx` 0: as high as what is in it. Call endDialog() when it returned true.
[[nodiscard]] bool beginDialog(Ui& ui, const char* id, const char* title, float width,
                               float height = 0.0f);
void endDialog();
// A right-aligned row of `count` buttons: puts the cursor where the first one goes.
void placeButtons(Ui& ui, ImVec2 button, int count);
// Went down this frame; ImGui's own names.
[[nodiscard]] bool pressedKey(ImGuiKey_ key);
[[nodiscard]] bool pressedEnter();  // or that of the keypad

}  // namespace voxprite::editor
