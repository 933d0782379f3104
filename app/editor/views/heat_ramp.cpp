#include "app/editor/views/heat_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/oklab.h"
#include "core/sprite/camera.h"

namespace voxprite::editor {
namespace {

constexpr int kSteps = 256;
constexpr double kDarkest = 0.13, kLightest = 0.96;

// Colourful in the middle, where sRGB has room for it.
struct Stop {
    double chroma;
    double hueDegrees;
};
constexpr std::array kStops{Stop{0.02, 290.0}, Stop{0.13, 300.0}, Stop{0.19, 357.0},
                            Stop{0.16, 410.0}, Stop{0.09, 465.0}};

Rgba8 colourAt(double share) {
    const double place = share * static_cast<double>(kStops.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const Stop &a = kStops[first], &b = kStops[first + 1];
    const double within = place - static_cast<double>(first);
    const double chroma = std::lerp(a.chroma, b.chroma, within);
    const SinCos hue = sinCosDegrees(std::lerp(a.hueDegrees, b.hueDegrees, within));
    return rgba8From({std::lerp(kDarkest, kLightest, share), chroma * hue.cos, chroma * hue.sin});
}

}  // namespace

Rgba8 heatColour(double error) {
    static const std::array<Rgba8, kSteps> kColours = [] {
        std::array<Rgba8, kSteps> colours;
        for (int k = 0; k < kSteps; ++k) {
            colours[static_cast<std::size_t>(k)] = colourAt(k / (kSteps - 1.0));
        }
        return colours;
    }();
    const double share = std::isnan(error) ? 1.0 : std::clamp(error, 0.0, 1.0);
    return kColours[static_cast<std::size_t>(std::lround(share * (kSteps - 1)))];
}

}  // namespace voxprite::editor
