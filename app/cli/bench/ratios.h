// Figures of a run of `voxprite bench` against those kept from the last landed report, and against
// the rivals measured in the same run. Works on the JSON of any part: what a figure is of are its
// texts and counts, what was measured are its times and rates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/bench/bench.h"
#include "app/cli/text_table.h"

namespace voxprite::bench {

struct Ratio {
    std::string part;     // "cast"
    std::string what;     // "shell128, parallel, scalar, threads 1"
    std::string measure;  // "mrays_per_s"
    double now = 0.0;
    // How many times as fast as then; none where nothing was kept.
    std::optional<double> toKept;
    // How many times as fast as the fastest rival of the same figure; none without rivals.
    std::optional<double> toRival;
    std::string rival;
};

// Of each figure that is ours, in order. `kept` as keptFigures() gives it, or null.
[[nodiscard]] std::vector<Ratio> ratiosOf(const Json& run, const Json& kept);

// What is kept of a run, small: {"voxprite_figures": 1, "commit", "machine", "figures": {"cast":
// [{..., "mrays_per_s"}], ...}}. Rivals are measured anew each time and not kept.
[[nodiscard]] Json keptFigures(const Json& run, const std::string& commit);

// As a table, with the machine that the kept ones are of. 1.5 is half as fast again.
[[nodiscard]] std::string ratioTable(const std::vector<Ratio>& ratios, const Json& kept,
                                     cli::TableStyle style);
[[nodiscard]] Json jsonOf(const std::vector<Ratio>& ratios);

}  // namespace voxprite::bench
