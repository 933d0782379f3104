// How long the GPU takes for what is drawn between begin() and end(), by its own clock.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "render/gl/handles.h"

namespace voxprite::gl {

// Pairs of begin() and end() of all timers must not overlap (GL measures one span at a time).
class TimerQuery {
  public:
    TimerQuery();  // needs a current context
    void begin();
    void end();
    // Milliseconds of the newest span that the GPU is done with; nothing before the first. Never
    // waits: for a figure on the screen.
    [[nodiscard]] std::optional<double> readyMs();
    // Milliseconds of the last span; waits until the GPU is done with it. Call after end().
    [[nodiscard]] double waitMs();

  private:
    // A GPU may be a few frames behind.
    static constexpr std::size_t kSpans = 4;
    std::array<Query, kSpans> spans_;
    std::size_t begun_ = 0;  // so many spans; the newest is spans_[(begun_ - 1) % kSpans]
    std::size_t read_ = 0;   // so many of them are known
    std::optional<double> newestMs_;
};

}  // namespace voxprite::gl
