// FLIP: how different two pictures look when a viewer flips between them (0 equal ... 1).
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator
// for Alternating Images", 2020 (the LDR measure). A colour pipeline (contrast sensitivity filters
// in YCxCz, Hunt-adjusted L*a*b*, HyAB distance) and a feature pipeline (edges and points of the
// luminance) are combined a pixel.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/base/image.h"
#include "core/measure/plane.h"

namespace voxprite {

// A 0.7 m wide display of 3840 pixels seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0;

// A picture as the eye has it: what takes longest, and is the same whatever it is compared with.
struct PerceivedPicture {
    std::vector<glm::dvec3> colours;  // filtered, in Hunt-adjusted L*a*b*
    Plane edges, points;              // magnitudes, of the luminance
};
// Of an opaque sRGB picture (alpha is ignored), not empty.
[[nodiscard]] PerceivedPicture perceive(const Image& image,
                                        double pixelsPerDegree = kFlipPixelsPerDegree);

// The error a pixel, of pictures of one size perceived at the same pixels a degree.
[[nodiscard]] Plane flipMap(const PerceivedPicture& reference, const PerceivedPicture& test);
// The error a pixel. Both pictures of one size, not empty, read as opaque sRGB (alpha is ignored).
[[nodiscard]] Plane flipMap(const Image& reference, const Image& test,
                            double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace voxprite
