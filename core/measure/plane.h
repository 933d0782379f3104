// One channel of a picture in floating point, and separable filters over it.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace voxprite {

struct Plane {
    int width = 0;
    int height = 0;
    std::vector<double> values;  // row by row from the top

    Plane() = default;
    Plane(int widthPx, int heightPx)
        : width(widthPx),
          height(heightPx),
          values(static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx)) {}
    [[nodiscard]] double at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    [[nodiscard]] double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

// weights[k] belongs to the offset k - size / 2 (odd sizes). Written as a correlation: a positive
// offset reads to the right, or below. Beyond the border the border's value goes on.
[[nodiscard]] Plane filterSeparable(const Plane& plane, std::span<const double> alongX,
                                    std::span<const double> alongY);

// weight(offset) for offsets -radius ... radius.
[[nodiscard]] std::vector<double> sampleKernel(int radius,
                                               const std::function<double(double)>& weight);

}  // namespace voxprite
