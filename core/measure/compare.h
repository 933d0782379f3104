// How different are two pictures? The measures of `voxprite compare` and of the trade reports.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/image.h"
#include "core/base/result.h"
#include "core/measure/flip.h"

namespace voxprite {

// FLIP and SSIM are measures of opaque pictures: what is transparent is laid over this grey first,
// against which a black outline and a bright face both stand out. Opaque pictures are not touched.
inline constexpr Rgba8 kComparisonBackground{128, 128, 128, 255};

struct ImageComparison {
    std::uint64_t pixels = 0;
    std::uint64_t mismatched = 0;  // any of R, G, B, A differs (two transparent pixels are equal)
    double mismatchRate = 0.0;     // mismatched / pixels
    std::uint64_t covered = 0;     // pixels opaque in either (alpha >= 128)
    double mismatchInside = 0.0;   // mismatched / covered; 0 when nothing is
    std::uint64_t silhouetteXor = 0;  // pixels opaque in exactly one
    // silhouetteXor over the pixels opaque in `a`; infinite when there are none but in `b`.
    double silhouetteXorShare = 0.0;
    double iou = 1.0;            // of the silhouettes; 1 when both are empty
    double boundaryIou = 1.0;    // of their borders, see core/measure/mask.h
    double flipMean = 0.0;       // see core/measure/flip.h
    double flipInside = 0.0;     // the mean over what is opaque in either; 0 when nothing is
    std::optional<double> psnr;  // decibels over RGBA, premultiplied; none when equal
    double ssim = 1.0;           // see core/measure/ssim.h; of the luma
};

// A picture that is compared with many: what FLIP makes of it alone is worked out once, when it is
// first needed. The picture itself is the caller's and outlives this. Of one thread at a time.
class ComparedPicture {
  public:
    explicit ComparedPicture(const Image& image, double pixelsPerDegree = kFlipPixelsPerDegree)
        : image_(&image), pixelsPerDegree_(pixelsPerDegree) {}
    [[nodiscard]] const Image& image() const { return *image_; }
    // Over the comparison's background.
    [[nodiscard]] const PerceivedPicture& perceived() const;

  private:
    const Image* image_;
    double pixelsPerDegree_;
    mutable std::optional<PerceivedPicture> perceived_;
};

// Fails when the sizes differ or a picture is empty. Both are of the same pixels a degree.
[[nodiscard]] Result<ImageComparison> compareImages(const ComparedPicture& a,
                                                    const ComparedPicture& b);
// Fails when the sizes differ or a picture is empty. FLIP's view is that of a display with so many
// pixels a degree.
[[nodiscard]] Result<ImageComparison> compareImages(const Image& a, const Image& b,
                                                    double pixelsPerDegree = kFlipPixelsPerDegree);

// FLIP a pixel of the pictures over the comparison's background: where they differ, and how much.
[[nodiscard]] Result<Plane> flipErrors(const Image& a, const Image& b,
                                       double pixelsPerDegree = kFlipPixelsPerDegree);

// ImageComparison::flipInside alone: how different the things in two pictures look, however much
// empty room there is around them. Fails as compareImages does.
[[nodiscard]] Result<double> flipInside(const Image& a, const Image& b);

}  // namespace voxprite
