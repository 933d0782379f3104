#include "core/measure/compare.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/measure/mask.h"
#include "core/measure/ssim.h"

namespace voxprite {
namespace {

std::string sizeText(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

// What a viewer sees of straight-alpha colours over the comparison's background.
Image overBackground(const Image& image) {
    Image opaque = image;
    for (Rgba8& pixel : opaque.pixels) {
        const int alpha = pixel.w;
        for (int channel = 0; channel < 3; ++channel) {
            pixel[channel] = static_cast<std::uint8_t>(
                (pixel[channel] * alpha + kComparisonBackground[channel] * (255 - alpha) + 127) /
                255);
        }
        pixel.w = 255;
    }
    return opaque;
}

// ITU-R BT.601.
Plane lumaOf(const Image& image) {
    Plane luma(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), luma.values.begin(),
                   [](Rgba8 c) { return 0.299 * c.x + 0.587 * c.y + 0.114 * c.z; });
    return luma;
}

double squaredError(Rgba8 a, Rgba8 b) {
    const double alphaA = a.w / 255.0;
    const double alphaB = b.w / 255.0;
    double sum = (a.w - b.w) * (a.w - b.w);
    for (int channel = 0; channel < 3; ++channel) {
        const double difference = a[channel] * alphaA - b[channel] * alphaB;
        sum += difference * difference;
    }
    return sum;
}

Status comparable(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) {
        return fail("the pictures differ in size: " + sizeText(a) + " and " + sizeText(b));
    }
    if (a.pixels.empty()) return fail("the pictures are empty");
    return {};
}

double meanWhereEither(const Plane& errors, const Mask& a, const Mask& b) {
    double sum = 0.0;
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < errors.values.size(); ++k) {
        if (a.set[k] == 0 && b.set[k] == 0) continue;
        sum += errors.values[k];
        ++count;
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace

Result<double> flipInside(const Image& a, const Image& b) {
    if (const Status can = comparable(a, b); !can) return Failure(can.error());
    if (a == b) return 0.0;
    return meanWhereEither(flipMap(overBackground(a), overBackground(b)), silhouetteOf(a),
                           silhouetteOf(b));
}

Result<Plane> flipErrors(const Image& a, const Image& b, double pixelsPerDegree) {
    if (const Status can = comparable(a, b); !can) return Failure(can.error());
    return flipMap(overBackground(a), overBackground(b), pixelsPerDegree);
}

const PerceivedPicture& ComparedPicture::perceived() const {
    if (!perceived_) perceived_ = perceive(overBackground(*image_), pixelsPerDegree_);
    return *perceived_;
}

Result<ImageComparison> compareImages(const Image& a, const Image& b, double pixelsPerDegree) {
    return compareImages(ComparedPicture(a, pixelsPerDegree), ComparedPicture(b, pixelsPerDegree));
}

Result<ImageComparison> compareImages(const ComparedPicture& pictureA,
                                      const ComparedPicture& pictureB) {
    const Image &a = pictureA.image(), &b = pictureB.image();
    if (const Status can = comparable(a, b); !can) return Failure(can.error());
    ImageComparison result;
    result.pixels = a.pixels.size();
    double errorSum = 0.0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        const Rgba8 pa = a.pixels[k];
        const Rgba8 pb = b.pixels[k];
        const bool bothTransparent = pa.w == 0 && pb.w == 0;
        if (pa != pb && !bothTransparent) ++result.mismatched;
        errorSum += squaredError(pa, pb);
    }
    const auto pixels = static_cast<double>(result.pixels);
    result.mismatchRate = static_cast<double>(result.mismatched) / pixels;
    const Mask inA = silhouetteOf(a);
    const Mask inB = silhouetteOf(b);
    const Overlap silhouettes = overlapOf(inA, inB);
    result.covered = silhouettes.united;
    if (result.covered > 0)
        result.mismatchInside =
            static_cast<double>(result.mismatched) / static_cast<double>(result.covered);
    result.silhouetteXor = silhouettes.differing();
    if (result.silhouetteXor > 0)
        result.silhouetteXorShare =
            static_cast<double>(result.silhouetteXor) / static_cast<double>(inA.count());
    result.iou = silhouettes.iou();
    result.boundaryIou = boundaryIou(inA, inB, boundaryDistancePx(a.width, a.height));
    if (result.mismatched == 0) return result;

    result.psnr = 10.0 * std::log10(255.0 * 255.0 / (errorSum / (4.0 * pixels)));
    const Plane flip = flipMap(pictureA.perceived(), pictureB.perceived());
    result.flipMean = std::accumulate(flip.values.begin(), flip.values.end(), 0.0) / pixels;
    result.flipInside = meanWhereEither(flip, inA, inB);
    result.ssim = meanSsim(lumaOf(overBackground(a)), lumaOf(overBackground(b)));
    return result;
}

}  // namespace voxprite
