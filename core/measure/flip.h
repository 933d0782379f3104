// FLIP: how different two pictures look when a viewer flips between them (0 equal ... 1).
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator
// for Alternating Images", 2020 (the LDR measure). A colour pipeline (contrast sensitivity filters
// in YCxCz, Hunt-adjusted L*a*b*, HyAB distance) and a feature pipeline (edges and points of the
// luminance) are combined a pixel.
#pragma once

#include "core/base/image.h"
#include "core/measure/plane.h"

namespace voxprite {

// A 0.7 m wide display of 3840 pixels seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0;

// The error a pixel. Both pictures of one size, not empty, read as opaque sRGB (alpha is ignored).
[[nodiscard]] Plane flipMap(const Image& reference, const Image& test,
                            double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace voxprite
