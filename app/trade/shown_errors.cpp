#include "app/trade/shown_errors.h"

#include <algorithm>
#include <cmath>

#include "app/trade/meter.h"
#include "core/measure/compare.h"
#include "core/measure/ids.h"
#include "core/measure/mask.h"
#include "core/sprite/sprite_buffer.h"

namespace voxprite::trade {
namespace {

// What outlines there are: by the ids, which know them from black voxels.
Mask outlineOf(const Image& image, std::span<const std::uint32_t> ids) {
    Mask mask(image.width, image.height);
    for (std::size_t k = 0; k < ids.size(); ++k) mask.set[k] = ids[k] == kIdOutline ? 1 : 0;
    return mask;
}

template <class Of>
double meanOf(const std::vector<PictureErrors>& all, Of of) {
    double sum = 0.0;
    for (const PictureErrors& one : all) sum += of(one);
    return all.empty() ? 0.0 : sum / static_cast<double>(all.size());
}

template <class Of>
std::optional<double> meanOfKnown(const std::vector<PictureErrors>& all, Of of) {
    double sum = 0.0;
    int count = 0;
    for (const PictureErrors& one : all)
        if (const std::optional<double> value = of(one)) {
            sum += *value;
            ++count;
        }
    if (count == 0) return std::nullopt;
    return sum / count;
}

double squaredErrorOf(const PictureErrors& errors) {
    return errors.psnr ? std::pow(10.0, -*errors.psnr / 10.0) : 0.0;
}

}  // namespace

Result<PictureErrors> compareShown(const ComparedPicture& yardstick,
                                   std::span<const std::uint32_t> yardstickIds,
                                   const ComparedPicture& test,
                                   std::span<const std::uint32_t> testIds) {
    const Result<ImageComparison> pictures = compareImages(yardstick, test);
    if (!pictures) return Failure(pictures.error());
    PictureErrors errors;
    errors.mismatch = pictures->mismatchInside;
    errors.silhouette = pictures->silhouetteXorShare;
    errors.iou = pictures->iou;
    errors.boundaryIou = pictures->boundaryIou;
    errors.flip = errors.flipWorst = pictures->flipInside;
    errors.psnr = pictures->psnr;
    errors.ssim = pictures->ssim;
    if (yardstickIds.empty() || testIds.empty()) return errors;
    const Result<IdComparison> ids = compareIds(yardstickIds, testIds, kIdFirstVoxel);
    if (!ids) return Failure(ids.error());
    errors.voxels = ids->rate();
    const Mask wanted = outlineOf(yardstick.image(), yardstickIds);
    if (wanted.count() == 0) return errors;
    const LineScore score = lineScore(wanted, outlineOf(test.image(), testIds));
    errors.outlineKept = score.recall;
    errors.outlineTrue = score.precision;
    return errors;
}

Result<Plane> errorMap(const Shown& yardstick, const Shown& test, double flipPixelsPerDegree) {
    return flipErrors(yardstick.image, test.image, flipPixelsPerDegree);
}

PictureErrors ErrorMean::mean() const {
    PictureErrors mean;
    mean.mismatch = meanOf(all_, [](const PictureErrors& e) { return e.mismatch; });
    mean.voxels = meanOfKnown(all_, [](const PictureErrors& e) { return e.voxels; });
    mean.silhouette = meanOf(all_, [](const PictureErrors& e) { return e.silhouette; });
    mean.iou = meanOf(all_, [](const PictureErrors& e) { return e.iou; });
    mean.boundaryIou = meanOf(all_, [](const PictureErrors& e) { return e.boundaryIou; });
    mean.outlineKept = meanOfKnown(all_, [](const PictureErrors& e) { return e.outlineKept; });
    mean.outlineTrue = meanOfKnown(all_, [](const PictureErrors& e) { return e.outlineTrue; });
    mean.flip = meanOf(all_, [](const PictureErrors& e) { return e.flip; });
    for (const PictureErrors& one : all_) mean.flipWorst = std::max(mean.flipWorst, one.flip);
    const double squared = meanOf(all_, squaredErrorOf);
    if (squared > 0.0) mean.psnr = -10.0 * std::log10(squared);
    mean.ssim = meanOf(all_, [](const PictureErrors& e) { return e.ssim; });
    return mean;
}

void NumberMean::add(const NumberErrors& errors) {
    if (!sum_) sum_.emplace();
    const auto before = static_cast<double>(sum_->samples);
    const auto added = static_cast<double>(errors.samples);
    sum_->samples += errors.samples;
    if (sum_->samples == 0) return;
    sum_->voxels = (sum_->voxels * before + errors.voxels * added) / (before + added);
    sum_->silhouette = (sum_->silhouette * before + errors.silhouette * added) / (before + added);
}

}  // namespace voxprite::trade
