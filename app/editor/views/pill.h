// What is written over a view stands on a dark pill, whatever the theme.
#pragma once

#include <imgui.h>

namespace voxprite::editor {

inline constexpr ImU32 kPill = IM_COL32(16, 17, 19, 222);
inline constexpr ImU32 kPillText = IM_COL32(240, 241, 243, 255);
inline constexpr ImU32 kPillDim = IM_COL32(186, 190, 197, 255);

}  // namespace voxprite::editor
