// Marks that tools draw over the edit view, the same for all of them.
#pragma once

#include "app/editor/views/picking.h"
#include "app/editor/views/view_drawing.h"
#include "app/editor/window/theme.h"
#include "core/edit/patches.h"

namespace voxprite::editor {

// Red takes away, the accent adds and paints.
[[nodiscard]] inline ImU32 colourOf(const Theme& theme, EditMode mode) {
    return mode == EditMode::erase ? theme.danger : theme.accent;
}

// The face under the pointer.
void markFace(const ViewDrawing& drawing, const Theme& theme, const Pick& pick, EditMode mode);
// The size of a box beside its upper right corner on screen.
void markSize(const ViewDrawing& drawing, const Theme& theme, const IBox& box);
[[nodiscard]] std::string sizeText(glm::ivec3 size);

}  // namespace voxprite::editor
