// How different are two pictures? The measures of `voxprite compare` and of the trade reports.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

struct ImageComparison {
    std::uint64_t pixels = 0;
    std::uint64_t mismatched = 0;  // any of R, G, B, A differs (two transparent pixels are equal)
    double mismatchRate = 0.0;     // mismatched / pixels
    std::uint64_t silhouetteXor = 0;  // pixels opaque in exactly one (alpha >= 128)
    double iou = 1.0;                 // of the silhouettes; 1 when both are empty
    double flipMean = 0.0;            // FLIP, Andersson et al. 2020, LDR, 67 pixels a degree
    std::optional<double> psnr;       // decibels over RGBA, premultiplied; none when equal
    double ssim = 1.0;                // Wang et al. 2004: luma, 11x11 Gaussian, sigma 1.5
};

// Fails when the sizes differ or a picture is empty.
[[nodiscard]] Result<ImageComparison> compareImages(const Image& a, const Image& b);

}  // namespace voxprite
