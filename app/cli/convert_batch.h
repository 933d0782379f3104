// voxprite convert --out-dir: many files at once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/io/formats.h"

namespace voxprite::cli {

struct BatchCommand {
    std::vector<std::string> inputs;
    std::string folder;
    std::string to = "voxprite";
    int jobs = 0;  // 0: as many as there are cores
    std::optional<std::string> log;
    std::optional<std::string> profile;
    std::optional<std::string> variant;
    bool strict = false;
    bool quiet = false;  // nothing on standard error
    ReadOptions reading;
    WriteOptions writing;
};

// Progress goes to standard error; with a log a JSON object a line, in the order of the inputs, as
// soon as they are done. Fails (with its report) where any file did.
[[nodiscard]] Result<Report> convertBatch(const BatchCommand& batch);

// "IN: .qb has no frames: 3 left out", a line each on standard error.
void tellLosses(const std::string& input, const std::vector<std::string>& losses);

}  // namespace voxprite::cli
