#include "app/editor/window/frame_clock.h"

#include <ctime>

#include <algorithm>

namespace voxprite::editor {
namespace {

double milliseconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace

void FrameClock::begin() {
    begunAt_ = milliseconds(CLOCK_MONOTONIC);
    busyAt_ = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    now_ = {};
}

void FrameClock::end(FramePart part) {
    const double busy = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    now_[static_cast<std::size_t>(part)] += busy - busyAt_;
    busyAt_ = busy;
}

void FrameClock::finish() {
    end(FramePart::present);
    longestFrame_ = std::max(longestFrame_, milliseconds(CLOCK_MONOTONIC) - begunAt_);
    longestOwn_ = std::max(longestOwn_, now_[static_cast<std::size_t>(FramePart::work)] +
                                            now_[static_cast<std::size_t>(FramePart::upload)]);
    for (std::size_t i = 0; i < kParts; ++i) longest_[i] = std::max(longest_[i], now_[i]);
}

void FrameClock::forget() {
    longestFrame_ = longestOwn_ = 0.0;
    longest_ = {};
}

}  // namespace voxprite::editor
