// Other programs, run to their end and measured: what converters are compared by.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voxprite::bench {

struct ProgramRun {
    bool started = false;         // there is such a program
    bool succeeded = false;       // and it ended with 0
    double ms = 0.0;              // from its start to its end
    double cpuMs = 0.0;           // of all its threads, user and system
    std::uint64_t peakBytes = 0;  // looked at every millisecond
};

// Looks the program up in PATH; its output is thrown away.
[[nodiscard]] ProgramRun runProgram(const std::vector<std::string>& arguments);
// The path of this program.
[[nodiscard]] std::string ownProgram();

}  // namespace voxprite::bench
