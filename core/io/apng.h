// Animated PNG: a PNG that moves where a viewer knows how, and else shows its first frame. Lossless
// with full alpha, which GIF has neither of. (W3C PNG third edition: acTL, fcTL and fdAT chunks.)
#pragma once

#include <span>

#include "core/base/bytes.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

struct AnimationFrame {
    Image image;
    int milliseconds = 100;  // at least 1
};

// Plays for ever. Frames of one size, at least one; fails else, and as writePng does. Times above
// 65 seconds are held to hundredths of a second, and longer ones more coarsely.
[[nodiscard]] Result<Bytes> writeApng(std::span<const AnimationFrame> frames);

}  // namespace voxprite
