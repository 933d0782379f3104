// The processor's own counters, of the calling thread, where the system lets programs read them
// (Linux: perf_event_open; virtual machines and hardened systems often do not).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "app/cli/bench/bench.h"

namespace voxprite::bench {

class HardwareCounters {
  public:
    struct Counts {
        std::uint64_t instructions = 0, cycles = 0, branchMisses = 0, cacheMisses = 0;
        Counts& operator+=(const Counts& other);
    };

    HardwareCounters();
    ~HardwareCounters();
    HardwareCounters(const HardwareCounters&) = delete;
    HardwareCounters& operator=(const HardwareCounters&) = delete;

    // Empty when they can be read.
    [[nodiscard]] const std::string& whyNone() const { return whyNone_; }
    void start();
    [[nodiscard]] Counts stop();  // since start(); zeros where there are none

  private:
    std::array<int, 4> files_{-1, -1, -1, -1};
    std::string whyNone_;
};

// For "machine": true, or why there are none.
[[nodiscard]] Json describe(const HardwareCounters& counters);
// Adds "instructions_per_<unit>" and its like; nothing where there are no counters.
void addCounts(Json& figure, const HardwareCounters::Counts& counts, double units,
               const std::string& unit);

}  // namespace voxprite::bench
