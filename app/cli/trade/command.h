// The part of `voxprite trade` that measures settings and writes a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/io/formats.h"

namespace voxprite::trade {

struct ReportOptions {
    std::string folder;
    std::vector<std::string> files;
    ReadOptions reading;
    std::vector<std::string> axes;  // by nameOf(Axis); empty: all
    std::optional<std::string> profile;
    std::optional<std::string> way;  // a file, camera_way.h
    bool quick = false;
    bool costs = false;  // those that grow
    bool markdown = false;
    std::string backend = "auto";  // "auto", "cpu" or "gl"
    std::string yardstick = "sprite";
    std::uint64_t seed = 1;
    std::optional<double> budgetMs, budgetError;
    std::optional<std::string> writeProfile;
};

void addReportOptions(CLI::App& sub, ReportOptions& options);
// Wrong usage is thrown, as everywhere.
[[nodiscard]] Result<cli::Report> reportTrade(const ReportOptions& options);

}  // namespace voxprite::trade
