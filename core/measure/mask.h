// Sets of pixels, and how far two of them agree: silhouettes, their borders, outlines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

struct Mask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> set;  // 0 or 1, row by row from the top

    Mask() = default;
    Mask(int widthPx, int heightPx)
        : width(widthPx),
          height(heightPx),
          set(static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx)) {}
    [[nodiscard]] std::uint64_t count() const;
    bool operator==(const Mask&) const = default;
};

// alpha >= 128.
[[nodiscard]] Mask silhouetteOf(const Image& image);
// The opaque pixels of exactly this colour.
[[nodiscard]] Mask pixelsOfColour(const Image& image, Rgba8 colour);

// Pixels whose whole (2 r + 1)-square lies in the mask; beyond the picture nothing is set.
[[nodiscard]] Mask eroded(const Mask& mask, int radiusPx);
// Pixels that have one of the mask's in their (2 r + 1)-square.
[[nodiscard]] Mask dilated(const Mask& mask, int radiusPx);

struct Overlap {
    std::uint64_t common = 0;
    std::uint64_t united = 0;
    // Set in exactly one of the two.
    [[nodiscard]] std::uint64_t differing() const { return united - common; }
    // Intersection over union; 1 when both are empty.
    [[nodiscard]] double iou() const {
        return united == 0 ? 1.0 : static_cast<double>(common) / static_cast<double>(united);
    }
};
// Masks of one size, here and below.
[[nodiscard]] Overlap overlapOf(const Mask& a, const Mask& b);

// The distance that Boundary IoU takes for a picture of that size: 2 % of its diagonal, at least 1.
[[nodiscard]] int boundaryDistancePx(int width, int height);
// Boundary IoU (Cheng, Girshick, Dollar, Berg, Kirillov 2021): the intersection over union of what
// lies within `distancePx` of each mask's own border, inside it. Large shapes that agree but for
// their edges score near 1 by IoU, and low here.
[[nodiscard]] double boundaryIou(const Mask& a, const Mask& b, int distancePx);

// How well thin lines agree: a pixel counts as found when one of the other's lies within the
// tolerance (in both directions, a square).
struct LineScore {
    double precision = 1.0;  // of the test's pixels, those that the reference has; 1 if none
    double recall = 1.0;     // of the reference's pixels, those that the test has; 1 if none
    // The harmonic mean.
    [[nodiscard]] double f1() const {
        return precision + recall == 0.0 ? 0.0 : 2.0 * precision * recall / (precision + recall);
    }
};
[[nodiscard]] LineScore lineScore(const Mask& reference, const Mask& test, int tolerancePx = 0);

}  // namespace voxprite
