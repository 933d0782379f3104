#include "core/base/oklab.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/newton_root.h"
#include "core/base/srgb.h"

namespace voxprite {

namespace {

double cubeRoot(double x) {
    // Brought near 1 by whole powers of 8, where few steps are needed.
    double scale = 1.0;
    while (x > 0.0 && x < 0.125) {
        x *= 8.0;
        scale *= 0.5;
    }
    return x > 0.0 ? scale * rootOf(std::min(x, 1.0), 3) : 0.0;
}

}  // namespace

OkLab okLabFrom(Rgba8 colour) {
    const double red = linearFromSrgb(colour.x), green = linearFromSrgb(colour.y),
                 blue = linearFromSrgb(colour.z);
    const double l = cubeRoot(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const double m = cubeRoot(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const double s = cubeRoot(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgba8 rgba8From(const OkLab& colour) {
    const double l =
        colour.lightness + 0.3963377774 * colour.greenRed + 0.2158037573 * colour.blueYellow;
    const double m =
        colour.lightness - 0.1055613458 * colour.greenRed - 0.0638541728 * colour.blueYellow;
    const double s =
        colour.lightness - 0.0894841775 * colour.greenRed - 1.2914855480 * colour.blueYellow;
    const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {srgbFromLinear(4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3),
            srgbFromLinear(-1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3),
            srgbFromLinear(-0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3), 255};
}

double squaredDistance(const OkLab& a, const OkLab& b) {
    const double lightness = a.lightness - b.lightness;
    const double greenRed = a.greenRed - b.greenRed;
    const double blueYellow = a.blueYellow - b.blueYellow;
    return lightness * lightness + greenRed * greenRed + blueYellow * blueYellow;
}

OkLab mix(const OkLab& a, const OkLab& b, double share) {
    const auto between = [share](double from, double to) { return from + (to - from) * share; };
    return {between(a.lightness, b.lightness), between(a.greenRed, b.greenRed),
            between(a.blueYellow, b.blueYellow)};
}

double chromaOf(const OkLab& colour) {
    return std::hypot(colour.greenRed, colour.blueYellow);
}

double hueDegreesOf(const OkLab& colour) {
    constexpr double kGrey = 1e-4;
    if (chromaOf(colour) < kGrey) return 0.0;
    const double degrees =
        std::atan2(colour.blueYellow, colour.greenRed) * 180.0 / std::numbers::pi;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

}  // namespace voxprite
