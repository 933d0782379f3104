#include "core/measure/ssim.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace voxprite {
namespace {

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    std::transform(a.values.begin(), a.values.end(), b.values.begin(), result.values.begin(),
                   std::multiplies<>());
    return result;
}

}  // namespace

double meanSsim(const Plane& a, const Plane& b) {
    constexpr double c1 = (0.01 * 255.0) * (0.01 * 255.0);
    constexpr double c2 = (0.03 * 255.0) * (0.03 * 255.0);
    const auto window = [](int radius) {
        std::vector<double> weights =
            sampleKernel(radius, [](double x) { return std::exp(-x * x / (2.0 * 1.5 * 1.5)); });
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        for (double& weight : weights) weight /= sum;
        return weights;
    };
    const int radiusX = std::min(5, (a.width - 1) / 2);
    const int radiusY = std::min(5, (a.height - 1) / 2);
    const std::vector<double> alongX = window(radiusX);
    const std::vector<double> alongY = window(radiusY);
    const auto mean = [&](const Plane& plane) { return filterSeparable(plane, alongX, alongY); };

    const Plane meanA = mean(a);
    const Plane meanB = mean(b);
    const Plane meanAA = mean(product(a, a));
    const Plane meanBB = mean(product(b, b));
    const Plane meanAB = mean(product(a, b));
    double sum = 0.0;
    for (int y = radiusY; y < a.height - radiusY; ++y) {
        for (int x = radiusX; x < a.width - radiusX; ++x) {
            const double ma = meanA.at(x, y);
            const double mb = meanB.at(x, y);
            const double varianceA = meanAA.at(x, y) - ma * ma;
            const double varianceB = meanBB.at(x, y) - mb * mb;
            const double covariance = meanAB.at(x, y) - ma * mb;
            sum += (2.0 * ma * mb + c1) * (2.0 * covariance + c2) /
                   ((ma * ma + mb * mb + c1) * (varianceA + varianceB + c2));
        }
    }
    return sum / (static_cast<double>(a.width - 2 * radiusX) *
                  static_cast<double>(a.height - 2 * radiusY));
}

}  // namespace voxprite
