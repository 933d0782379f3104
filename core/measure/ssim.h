// Structural similarity (1 equal), Wang, Bovik, Sheikh, Simoncelli 2004.
#pragma once

#include "core/measure/plane.h"

namespace voxprite {

// The mean over all windows that lie wholly inside: 11x11 Gaussian, deviation 1.5, K1 = 0.01,
// K2 = 0.03. Planes of one size, not empty, values 0 ... 255. On an axis shorter than the window,
// the window is the longest odd one that fits.
[[nodiscard]] double meanSsim(const Plane& a, const Plane& b);

}  // namespace voxprite
