// What bounds and mirrors edits, as lines in the edit view: the planes of symmetry and the box that
// limits edits.
#pragma once

#include <array>

#include "app/editor/tools/tool_options.h"
#include "core/base/image.h"
#include "render/overlay.h"

namespace voxprite::editor {

// The colours that axes have everywhere: red, green, blue.
inline constexpr std::array<Rgba8, 3> kAxisColours{
    Rgba8(240, 96, 96, 255), Rgba8(120, 210, 110, 255), Rgba8(100, 150, 255, 255)};

// In the edit view's world. Planes are drawn around `bounds`, those of the model; line widths at
// `scale` device pixels a pixel.
[[nodiscard]] OverlayShapes guidesOf(const ToolOptions& options, const IBox& bounds, float scale);

// Puts all planes through the middle of `bounds` (of the ground where there is no model).
void centreSymmetry(ToolOptions& options, const IBox& bounds);
// Switches one axis; the first one ever switched on finds its plane in the model's middle.
void switchSymmetry(ToolOptions& options, int axis, const IBox& bounds);
// The limiting box lies around the model until it was given another place.
void switchLimits(ToolOptions& options, const IBox& bounds);

}  // namespace voxprite::editor
