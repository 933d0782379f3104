// How restless a picture is while the camera moves: what changes from frame to frame.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/image.h"
#include "core/base/result.h"
#include "core/measure/mask.h"

namespace voxprite {

// Sums over the frames, each a share of what the two (flips: three) frames cover together.
struct TemporalFigures {
    int frames = 0;
    double degrees = 0.0;  // that the camera has turned
    // Pixels of another colour than in the frame before. (Two transparent ones are equal.)
    double changed = 0.0;
    // A -> B -> A: pixels that have the colour of two frames ago, but not that of the last.
    double flips = 0.0;
    // Crawl: pixels of the silhouette's border (those with one of their eight neighbours outside)
    // that came or went, of those that are border in either frame.
    double crawl = 0.0;

    // Of one of the sums, a degree of turn; 0 when the camera has not turned.
    [[nodiscard]] double aDegree(double sum) const { return degrees > 0.0 ? sum / degrees : 0.0; }
};

class TemporalMeter {
  public:
    // The next frame, for which the camera has turned by so much (of the first it does not count).
    // Fails when its size is another, or it is empty, or the turn is no number of 0 or more.
    [[nodiscard]] Status add(const Image& frame, double degreesTurned);
    [[nodiscard]] const TemporalFigures& figures() const { return figures_; }

  private:
    std::optional<Image> last_, secondLast_;
    Mask lastBorder_;
    TemporalFigures figures_;
};

}  // namespace voxprite
