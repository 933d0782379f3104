// The curve: error against cost, a dot a setting, with the front, the budget, A and B.
#pragma once

#include <optional>

#include "app/editor/panels/ui.h"
#include "app/trade/setting.h"

namespace voxprite::editor {

struct PlotAnswer {
    std::optional<trade::Setting> looked;  // clicked: to be seen as B
    std::optional<trade::Setting> taken;   // double-clicked: to be put into force
};
[[nodiscard]] PlotAnswer drawTradePlot(Ui& ui, const trade::Setting& inForce, ImVec2 size);

// Which colour is which axis of the settings; only those that there are points of.
void drawTradeLegend(Ui& ui);

}  // namespace voxprite::editor
