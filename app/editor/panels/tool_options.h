// The bar above the views: the options of the tool in hand, the figures of what it is making, and
// what holds for all tools: mirrors and limits.
#pragma once

#include "app/editor/panels/ui.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

// What the bar's buttons ask of the tool.
enum class ToolAnswer : std::uint8_t { none, keep, drop };

// Draws into the current ImGui window. `tool` may be null.
[[nodiscard]] ToolAnswer drawToolOptions(Ui& ui, Tool* tool);

}  // namespace voxprite::editor
