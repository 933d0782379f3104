#include "app/editor/views/drawing_times.h"

#include <algorithm>
#include <cmath>

namespace voxprite::editor {
namespace {

// Of a software rasteriser on one core: `voxprite bench --only clusters`.
constexpr double kSlowestMsPerTriangle = 6e-4;

}  // namespace

std::size_t DrawingTimes::sizeOf(double radiusPx) {
    // What is no number is no size: the smallest.
    if (!(radiusPx > 1.0)) return 0;
    return static_cast<std::size_t>(std::min(std::log2(radiusPx), kSizes - 1.0));
}

DrawingWay DrawingTimes::faster(double radiusPx, std::size_t triangles) const {
    const std::size_t size = sizeOf(radiusPx);
    const Known& rays = known_[0][size];
    const Known& clusters = known_[1][size];
    if (rays.frames < kFrames) return DrawingWay::rays;
    if (clusters.frames < kFrames) {
        const double feared = kSlowestMsPerTriangle * static_cast<double>(triangles);
        return feared <= 2.0 * rays.fastestMs ? DrawingWay::clusters : DrawingWay::rays;
    }
    return clusters.fastestMs < 0.9 * rays.fastestMs ? DrawingWay::clusters : DrawingWay::rays;
}

void DrawingTimes::took(DrawingWay way, double radiusPx, double milliseconds) {
    const auto index = static_cast<std::size_t>(way);
    if (!warm_[index]) {
        warm_[index] = true;
        return;
    }
    Known& known = known_[index][sizeOf(radiusPx)];
    known.fastestMs = known.frames == 0 ? milliseconds : std::min(known.fastestMs, milliseconds);
    ++known.frames;
}

}  // namespace voxprite::editor
