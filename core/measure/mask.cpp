#include "core/measure/mask.h"

#include <algorithm>
#include <cmath>

namespace voxprite {
namespace {

Mask maskOf(const Image& image, auto belongs) {
    Mask mask(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), mask.set.begin(),
                   [&](Rgba8 pixel) { return static_cast<std::uint8_t>(belongs(pixel)); });
    return mask;
}

// Along lines of `length` pixels, `step` apart in memory: set where the window of `radius` to both
// sides holds at least `wanted` (of 2 radius + 1, or 1) set pixels.
void filterLine(const std::uint8_t* from, std::uint8_t* to, int length, std::size_t step,
                int radius, int wanted) {
    int inWindow = 0;
    const auto at = [&](int k) { return from[static_cast<std::size_t>(k) * step]; };
    for (int k = 0; k < std::min(radius, length); ++k) inWindow += at(k);
    for (int k = 0; k < length; ++k) {
        if (k + radius < length) inWindow += at(k + radius);
        if (k - radius > 0) inWindow -= at(k - radius - 1);
        to[static_cast<std::size_t>(k) * step] = inWindow >= wanted ? 1 : 0;
    }
}

Mask filterSquare(const Mask& mask, int radius, int wanted) {
    const auto width = static_cast<std::size_t>(mask.width);
    Mask rows(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y) {
        const std::size_t line = static_cast<std::size_t>(y) * width;
        filterLine(mask.set.data() + line, rows.set.data() + line, mask.width, 1, radius, wanted);
    }
    Mask both(mask.width, mask.height);
    for (std::size_t x = 0; x < width; ++x) {
        filterLine(rows.set.data() + x, both.set.data() + x, mask.height, width, radius, wanted);
    }
    return both;
}

Mask boundaryOf(const Mask& mask, int distancePx) {
    Mask boundary = eroded(mask, distancePx);
    for (std::size_t k = 0; k < mask.set.size(); ++k) {
        boundary.set[k] = mask.set[k] != 0 && boundary.set[k] == 0 ? 1 : 0;
    }
    return boundary;
}

double shareWithin(const Mask& mask, const Mask& other, int tolerancePx) {
    const std::uint64_t all = mask.count();
    if (all == 0) return 1.0;
    const Overlap found = overlapOf(mask, dilated(other, tolerancePx));
    return static_cast<double>(found.common) / static_cast<double>(all);
}

}  // namespace

std::uint64_t Mask::count() const {
    return static_cast<std::uint64_t>(std::count(set.begin(), set.end(), std::uint8_t{1}));
}

Mask silhouetteOf(const Image& image) {
    return maskOf(image, [](Rgba8 pixel) { return pixel.w >= 128; });
}

Mask pixelsOfColour(const Image& image, Rgba8 colour) {
    return maskOf(image, [&](Rgba8 pixel) { return pixel == colour && pixel.w == 255; });
}

Mask eroded(const Mask& mask, int radiusPx) {
    return filterSquare(mask, radiusPx, 2 * radiusPx + 1);
}

Mask dilated(const Mask& mask, int radiusPx) {
    return filterSquare(mask, radiusPx, 1);
}

Overlap overlapOf(const Mask& a, const Mask& b) {
    Overlap overlap;
    for (std::size_t k = 0; k < a.set.size(); ++k) {
        overlap.common += a.set[k] & b.set[k];
        overlap.united += a.set[k] | b.set[k];
    }
    return overlap;
}

int boundaryDistancePx(int width, int height) {
    return std::max(1, static_cast<int>(std::lround(0.02 * std::hypot(width, height))));
}

double boundaryIou(const Mask& a, const Mask& b, int distancePx) {
    return overlapOf(boundaryOf(a, distancePx), boundaryOf(b, distancePx)).iou();
}

LineScore lineScore(const Mask& reference, const Mask& test, int tolerancePx) {
    return {shareWithin(test, reference, tolerancePx), shareWithin(reference, test, tolerancePx)};
}

}  // namespace voxprite
