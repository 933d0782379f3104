#include "app/editor/window/frame_clock.h"

#include <algorithm>

namespace voxprite::editor {
void FrameClock::begin() {
    frame_ = {};
    busy_ = {};
    now_ = {};
}

void FrameClock::end(FramePart part) {
    now_[static_cast<std::size_t>(part)] += busy_.lapMilliseconds();
}

void FrameClock::finish() {
    end(FramePart::present);
    longestFrame_ = std::max(longestFrame_, frame_.milliseconds());
    longestOwn_ = std::max(longestOwn_, now_[static_cast<std::size_t>(FramePart::work)] +
                                            now_[static_cast<std::size_t>(FramePart::upload)]);
    for (std::size_t i = 0; i < kParts; ++i) longest_[i] = std::max(longest_[i], now_[i]);
}

void FrameClock::forget() {
    longestFrame_ = longestOwn_ = 0.0;
    longest_ = {};
}

}  // namespace voxprite::editor
