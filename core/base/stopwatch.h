// Elapsed time by the steady clock.
#pragma once

#include <chrono>

namespace voxprite {

class Stopwatch {
  public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }
    // The time since the last lap, or since the start.
    double lapMilliseconds() {
        const double elapsed = milliseconds();
        start_ = Clock::now();
        return elapsed;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace voxprite
