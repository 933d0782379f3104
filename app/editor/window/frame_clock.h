// Where the window's thread spends the time of a frame, so that what makes it freeze can be named.
// Busy time is the thread's own: what other programs and the rasteriser's threads take is not in
// it, so it means the same on a loaded machine and on an idle one.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/stopwatch.h"
#include "core/base/thread_stopwatch.h"

namespace voxprite::editor {

enum class FramePart : std::uint8_t {
    work,     // the user interface, tools, edits: all that is the editor's own
    upload,   // octrees to the GPU
    draw,     // both views
    present,  // the user interface's triangles, and the swap
};

class FrameClock {
  public:
    static constexpr std::size_t kParts = 4;

    void begin();
    // What came since begin() or the last part belongs to `part`.
    void end(FramePart part);
    // The frame is over.
    void finish();
    // Another document: what was longest is forgotten.
    void forget();

    // Longest since then; milliseconds. The parts are busy time and need not be of one frame;
    // longestOwn() is that of work and upload of one frame: all but what the driver takes to draw.
    [[nodiscard]] double longestFrame() const { return longestFrame_; }
    [[nodiscard]] double longestOwn() const { return longestOwn_; }
    [[nodiscard]] double longest(FramePart part) const {
        return longest_[static_cast<std::size_t>(part)];
    }

  private:
    Stopwatch frame_;
    ThreadStopwatch busy_;
    double longestFrame_ = 0.0;
    double longestOwn_ = 0.0;
    std::array<double, kParts> now_{};
    std::array<double, kParts> longest_{};
};

}  // namespace voxprite::editor
