// Animated GIF (giflib), for places that do not play animated PNGs. Sprites have few colours, so
// that mostly nothing is lost: up to 255 colours are exact, more are reduced
// (core/io/colour_reduction.h). Transparency is all or nothing: alpha below 128 is transparent.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/apng.h"

namespace voxprite {

struct GifImage {
    Bytes bytes;
    // What of the pictures is not in the file, a sentence; nothing where they are exact.
    std::optional<std::string> loss;
};

// Plays for ever. Frames of one size, at most 65,535 pixels an edge; their times are told in
// hundredths of a second, 2 ... 65,535 of them, and add up. The same frames give the same bytes.
[[nodiscard]] Result<GifImage> writeGif(std::span<const AnimationFrame> frames);

}  // namespace voxprite
