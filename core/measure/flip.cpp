#include "core/measure/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <numeric>

#include "core/base/parallel.h"

namespace voxprite {
namespace {

constexpr double kPi = std::numbers::pi;

// CIE XYZ of the linear sRGB primaries, columns R, G, B; white is their sum (D65).
const glm::dmat3 kXyzFromRgb{
    {10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0},
    {8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0},
    {4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0}};
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

double linearFromSrgb(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// The opponent space that the eye's contrast sensitivity is described in: linear in XYZ.
glm::dvec3 ycxczFromRgb(glm::dvec3 linear) {
    const glm::dvec3 relative = kXyzFromRgb * linear / kWhite;
    return {116.0 * relative.y - 16.0, 500.0 * (relative.x - relative.y),
            200.0 * (relative.y - relative.z)};
}

glm::dvec3 rgbFromYcxcz(glm::dvec3 ycxcz) {
    const double y = (ycxcz.x + 16.0) / 116.0;
    const glm::dvec3 relative{y + ycxcz.y / 500.0, y, y - ycxcz.z / 200.0};
    return kRgbFromXyz * (relative * kWhite);
}

// L*a*b* with chroma scaled by lightness: colours of dark pixels differ less (the Hunt effect).
glm::dvec3 huntLabFromRgb(glm::dvec3 linear) {
    const glm::dvec3 relative = kXyzFromRgb * linear / kWhite;
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29.0;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
    };
    const double lightness = 116.0 * f(relative.y) - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f(relative.x) - f(relative.y)),
            0.01 * lightness * 200.0 * (f(relative.y) - f(relative.z))};
}

// City block in lightness, Euclidean in chroma: holds up for large differences.
double hyab(glm::dvec3 a, glm::dvec3 b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// A sum of two Gaussians in the frequency domain, given in degrees: a * sqrt(pi / b) *
// exp(-(pi * x)^2 / b). Each is separable.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivity{{{1.0, 0.0047, 0.0, 1e-5},     // Y
                                                   {1.0, 0.0053, 0.0, 1e-5},     // Cx
                                                   {34.1, 0.04, 13.5, 0.025}}};  // Cz
constexpr double kWidestB = 0.04;

Plane filterBySensitivity(const Plane& channel, const Sensitivity& s, double pixelsPerDegree) {
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * kPi * kPi)) * pixelsPerDegree));
    const auto gaussian = [&](double b) {
        return sampleKernel(radius, [&](double offset) {
            const double degrees = offset / pixelsPerDegree;
            return std::exp(-kPi * kPi * degrees * degrees / b);
        });
    };
    const auto sumOf = [](const std::vector<double>& kernel) {
        return std::accumulate(kernel.begin(), kernel.end(), 0.0);
    };
    const std::vector<double> g1 = gaussian(s.b1);
    const double c1 = s.a1 * std::sqrt(kPi / s.b1);
    const double sum1 = sumOf(g1);
    if (s.a2 == 0.0) {
        Plane filtered = filterSeparable(channel, g1, g1);
        for (double& value : filtered.values) value /= sum1 * sum1;
        return filtered;
    }
    const std::vector<double> g2 = gaussian(s.b2);
    const double c2 = s.a2 * std::sqrt(kPi / s.b2);
    const double sum2 = sumOf(g2);
    const double total = c1 * sum1 * sum1 + c2 * sum2 * sum2;
    Plane filtered = filterSeparable(channel, g1, g1);
    const Plane second = filterSeparable(channel, g2, g2);
    for (std::size_t k = 0; k < filtered.values.size(); ++k) {
        filtered.values[k] = (c1 * filtered.values[k] + c2 * second.values[k]) / total;
    }
    return filtered;
}

using Opponent = std::array<Plane, 3>;  // Y, Cx, Cz

Opponent opponentPlanes(const Image& image) {
    std::array<double, 256> linear;
    for (int k = 0; k < 256; ++k) linear[static_cast<std::size_t>(k)] = linearFromSrgb(k / 255.0);
    Opponent planes;
    planes.fill(Plane(image.width, image.height));
    for (std::size_t k = 0; k < image.pixels.size(); ++k) {
        const Rgba8 c = image.pixels[k];
        const glm::dvec3 ycxcz = ycxczFromRgb({linear[c.x], linear[c.y], linear[c.z]});
        for (int channel = 0; channel < 3; ++channel) {
            planes[static_cast<std::size_t>(channel)].values[k] = ycxcz[channel];
        }
    }
    return planes;
}

// Filtered as the eye would, in Hunt-adjusted L*a*b*.
std::vector<glm::dvec3> perceivedColours(const Opponent& planes, double pixelsPerDegree) {
    Opponent filtered;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        filtered[channel] =
            filterBySensitivity(planes[channel], kSensitivity[channel], pixelsPerDegree);
    }
    std::vector<glm::dvec3> colours(filtered[0].values.size());
    parallelFor(static_cast<int>(colours.size()), 0, [&](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
            const glm::dvec3 linear =
                rgbFromYcxcz({filtered[0].values[k], filtered[1].values[k], filtered[2].values[k]});
            colours[k] = huntLabFromRgb(glm::clamp(linear, 0.0, 1.0));
        }
    });
    return colours;
}

// Large distances are squeezed into the last 5 %, so that common ones keep their resolution.
double redistribute(double distance) {
    constexpr double exponent = 0.7;    // q_c
    constexpr double knee = 0.4;        // p_c
    constexpr double kneeValue = 0.95;  // p_t
    static const double largest =
        std::pow(hyab(huntLabFromRgb({0.0, 1.0, 0.0}), huntLabFromRgb({0.0, 0.0, 1.0})), exponent);
    const double power = std::pow(distance, exponent);
    const double limit = knee * largest;
    if (power < limit) return kneeValue / limit * power;
    return kneeValue + (power - limit) / (largest - limit) * (1.0 - kneeValue);
}

// Positive weights sum to 1, negative ones to -1.
std::vector<double> normaliseSigns(std::vector<double> weights) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double w : weights) (w > 0.0 ? positive : negative) += w;
    for (double& w : weights) w /= w > 0.0 ? positive : -negative;
    return weights;
}

struct Features {
    Plane edges, points;
};

Features featuresOf(const Plane& luminance, double pixelsPerDegree) {
    constexpr double widthDegrees = 0.082;  // w
    const double deviation = 0.5 * widthDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto gaussian = [&](double x) {
        return std::exp(-x * x / (2.0 * deviation * deviation));
    };
    std::vector<double> smooth = sampleKernel(radius, gaussian);
    const double sum = std::accumulate(smooth.begin(), smooth.end(), 0.0);
    for (double& weight : smooth) weight /= sum;
    const std::vector<double> edge =
        normaliseSigns(sampleKernel(radius, [&](double x) { return -x * gaussian(x); }));
    const std::vector<double> point = normaliseSigns(sampleKernel(
        radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }));
    const auto magnitude = [&](const std::vector<double>& kernel) {
        Plane along = filterSeparable(luminance, kernel, smooth);
        const Plane across = filterSeparable(luminance, smooth, kernel);
        for (std::size_t k = 0; k < along.values.size(); ++k) {
            along.values[k] = std::hypot(along.values[k], across.values[k]);
        }
        return along;
    };
    return {magnitude(edge), magnitude(point)};
}

Plane normalisedLuminance(Plane y) {
    for (double& value : y.values) value = (value + 16.0) / 116.0;
    return y;
}

}  // namespace

PerceivedPicture perceive(const Image& image, double pixelsPerDegree) {
    Opponent planes = opponentPlanes(image);
    std::vector<glm::dvec3> colours = perceivedColours(planes, pixelsPerDegree);
    Features features = featuresOf(normalisedLuminance(std::move(planes[0])), pixelsPerDegree);
    return {std::move(colours), std::move(features.edges), std::move(features.points)};
}

Plane flipMap(const Image& reference, const Image& test, double pixelsPerDegree) {
    return flipMap(perceive(reference, pixelsPerDegree), perceive(test, pixelsPerDegree));
}

Plane flipMap(const PerceivedPicture& a, const PerceivedPicture& b) {
    Plane map(a.edges.width, a.edges.height);
    parallelFor(static_cast<int>(map.values.size()), 0, [&](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
            const double colour = redistribute(hyab(a.colours[k], b.colours[k]));
            const double feature =
                std::sqrt(std::max(std::abs(a.edges.values[k] - b.edges.values[k]),
                                   std::abs(a.points.values[k] - b.points.values[k])) /
                          std::numbers::sqrt2);  // q_f = 0.5
            map.values[k] = std::pow(colour, 1.0 - feature);
        }
    });
    return map;
}

}  // namespace voxprite
