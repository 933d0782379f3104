// Runs `voxprite trade FILES -o DIR`: every setting of every model, then the costs that grow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/trade/report.h"
#include "core/io/formats.h"

namespace voxprite::trade {

struct RunOptions {
    std::vector<std::string> files;
    ReadOptions reading;
    std::string folder;                       // of the report: made before anything is measured
    std::optional<std::string> writeProfile;  // that the caller makes of what is found
    std::optional<std::string> profile;       // else what each file was authored with
    std::vector<Axis> axes = allAxes();
    std::vector<OrbitAngles> recordedWay;  // of the camera; empty: one of the meter's own
    bool quick = false;
    bool growth = false;
    bool gl = true;       // where there is OpenGL; else the processor
    bool needGl = false;  // fails where there is none
    std::uint64_t seed = 1;
};

// Says on stderr how far it is and what time is left. Ctrl+C ends it early: what was done comes
// back, and `finished` is false. A model whose own setting cannot be drawn is left out and noted in
// the report, and so is any other setting. What can be checked beforehand is: files, the folder,
// the profile's place, OpenGL.
[[nodiscard]] Result<TradeReport> runTrade(const RunOptions& options);

// All models' points as one curve, so that a choice holds for a whole game: the settings that all
// of them have, the errors and costs being means over models and sizes.
[[nodiscard]] Curve combined(const std::vector<ModelReport>& models);

}  // namespace voxprite::trade
