// The plots of a report, by the name of their PNG.
#pragma once

#include <string>
#include <vector>

#include "app/cli/trade/report.h"
#include "app/plot/plot.h"

namespace voxprite::trade {

struct NamedPlot {
    std::string name;     // "knight-front"
    std::string caption;  // a sentence: how to read it
    plot::Plot plot;
};
// Those that have anything to show; `prefix` begins their names.
[[nodiscard]] std::vector<NamedPlot> plotsOf(const ModelReport& model, const std::string& prefix);
[[nodiscard]] std::vector<NamedPlot> plotsOf(const std::vector<Growth>& growth);

// A name for files: letters, digits and dashes, the same for no two models of the report.
[[nodiscard]] std::vector<std::string> fileNames(const std::vector<ModelReport>& models);

}  // namespace voxprite::trade
