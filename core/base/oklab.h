// OKLab (Ottosson, "A perceptual color space for image processing", 2020): equal distances look
// about equally far apart, and a straight line between two colours keeps to what lies between.
#pragma once

#include "core/base/image.h"

namespace voxprite {

struct OkLab {
    double lightness = 0.0;   // 0 black ... 1 white
    double greenRed = 0.0;    // the paper's a, about -0.4 ... 0.4
    double blueYellow = 0.0;  // the paper's b
};

// Of an sRGB colour; alpha plays no part. Made of + - * / alone, so that every machine finds the
// same digits, and what is chosen by them is the same everywhere.
[[nodiscard]] OkLab okLabFrom(Rgba8 colour);
// The nearest sRGB colour, alpha 255; what lies outside sRGB is cut off channel by channel.
[[nodiscard]] Rgba8 rgba8From(const OkLab& colour);

[[nodiscard]] double squaredDistance(const OkLab& a, const OkLab& b);
// `share` 0 is a, 1 is b.
[[nodiscard]] OkLab mix(const OkLab& a, const OkLab& b, double share);

// How colourful, from 0 (a grey).
[[nodiscard]] double chromaOf(const OkLab& colour);
// The angle round the grey axis, 0 ... 360 degrees, red near 29; 0 for a grey.
[[nodiscard]] double hueDegreesOf(const OkLab& colour);

}  // namespace voxprite
