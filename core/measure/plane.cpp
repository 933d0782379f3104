#include "core/measure/plane.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace voxprite {

Plane filterSeparable(const Plane& plane, std::span<const double> alongX,
                      std::span<const double> alongY) {
    const int width = plane.width;
    const int height = plane.height;
    const int radiusX = static_cast<int>(alongX.size() / 2);
    const int radiusY = static_cast<int>(alongY.size() / 2);
    Plane rows(width, height);
    parallelFor(height, 0, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int x = 0; x < width; ++x) {
                double sum = 0.0;
                for (int k = -radiusX; k <= radiusX; ++k) {
                    sum += alongX[static_cast<std::size_t>(k + radiusX)] *
                           plane.at(std::clamp(x + k, 0, width - 1), y);
                }
                rows.at(x, y) = sum;
            }
        }
    });
    Plane filtered(width, height);
    parallelFor(height, 0, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int k = -radiusY; k <= radiusY; ++k) {
                const double weight = alongY[static_cast<std::size_t>(k + radiusY)];
                const int source = std::clamp(y + k, 0, height - 1);
                for (int x = 0; x < width; ++x) filtered.at(x, y) += weight * rows.at(x, source);
            }
        }
    });
    return filtered;
}

std::vector<double> sampleKernel(int radius, const std::function<double(double)>& weight) {
    std::vector<double> weights;
    for (int k = -radius; k <= radius; ++k) weights.push_back(weight(k));
    return weights;
}

}  // namespace voxprite
