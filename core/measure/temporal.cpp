#include "core/measure/temporal.h"

#include <cmath>

namespace voxprite {
namespace {

bool alike(Rgba8 a, Rgba8 b) {
    return a == b || (a.w == 0 && b.w == 0);
}

Mask borderOf(const Image& frame) {
    const Mask silhouette = silhouetteOf(frame);
    const Mask inner = eroded(silhouette, 1);
    Mask border = silhouette;
    for (std::size_t k = 0; k < border.set.size(); ++k)
        border.set[k] = silhouette.set[k] != 0 && inner.set[k] == 0 ? 1 : 0;
    return border;
}

double shareOf(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

double changedShare(const Image& before, const Image& now) {
    std::uint64_t covered = 0, changed = 0;
    for (std::size_t k = 0; k < now.pixels.size(); ++k) {
        covered += before.pixels[k].w != 0 || now.pixels[k].w != 0 ? 1 : 0;
        changed += alike(before.pixels[k], now.pixels[k]) ? 0 : 1;
    }
    return shareOf(changed, covered);
}

double flippedShare(const Image& first, const Image& second, const Image& third) {
    std::uint64_t covered = 0, flipped = 0;
    for (std::size_t k = 0; k < third.pixels.size(); ++k) {
        const Rgba8 a = first.pixels[k], b = second.pixels[k], c = third.pixels[k];
        covered += a.w != 0 || b.w != 0 || c.w != 0 ? 1 : 0;
        flipped += alike(a, c) && !alike(a, b) ? 1 : 0;
    }
    return shareOf(flipped, covered);
}

}  // namespace

Status TemporalMeter::add(const Image& frame, double degreesTurned) {
    if (frame.pixels.empty()) return fail("the frame is empty");
    if (!std::isfinite(degreesTurned) || degreesTurned < 0.0)
        return fail("the camera's turn must be 0 degrees or more");
    if (last_ && (last_->width != frame.width || last_->height != frame.height))
        return fail("the frames differ in size");
    Mask border = borderOf(frame);
    if (last_) {
        figures_.degrees += degreesTurned;
        figures_.changed += changedShare(*last_, frame);
        const Overlap borders = overlapOf(lastBorder_, border);
        figures_.crawl += shareOf(borders.differing(), borders.united);
        if (secondLast_) figures_.flips += flippedShare(*secondLast_, *last_, frame);
        secondLast_ = std::move(last_);
    }
    ++figures_.frames;
    last_ = frame;
    lastBorder_ = std::move(border);
    return {};
}

}  // namespace voxprite
