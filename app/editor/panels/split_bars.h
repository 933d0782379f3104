// The bars between the parts of the window: drag to move them, double-click to fold what is beside
// them.
#pragma once

#include "app/editor/panels/layout.h"
#include "app/editor/panels/ui.h"

namespace voxprite::editor {

void drawSplitBars(Ui& ui, const Layout& layout);

}  // namespace voxprite::editor
