// Errors and costs as people read them.
#pragma once

#include <imgui.h>

#include <string>

#include "app/trade/figures.h"

namespace voxprite::editor {

// The colour of B wherever it is told from A, which has the accent.
inline constexpr ImU32 kSideB = IM_COL32(96, 186, 255, 255);

[[nodiscard]] std::string percentText(double share);    // "0.42 %", "3.1 %", "12 %"
[[nodiscard]] std::string millisecondsText(double ms);  // "84 µs", "1.20 ms"
[[nodiscard]] std::string countText(double count);      // "17,031", "1.8 M"
// "12 % off    1.20 ms    17,031 rays", or that it is not measured.
[[nodiscard]] std::string figureText(const trade::Point* point, trade::Yardstick yardstick);

}  // namespace voxprite::editor
