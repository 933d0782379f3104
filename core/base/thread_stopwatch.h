// Time that the calling thread itself was busy: what other threads and programs do does not count.
#pragma once

#include <ctime>

namespace voxprite {

// Started, read and lapped by one thread.
class ThreadStopwatch {
  public:
    [[nodiscard]] double milliseconds() const { return now() - start_; }
    // The time since the last lap, or since the start.
    double lapMilliseconds() {
        const double before = start_;
        start_ = now();
        return start_ - before;
    }

  private:
    [[nodiscard]] static double now() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }

    double start_ = now();
};

}  // namespace voxprite
