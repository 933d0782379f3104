// The integer vector that points most nearly where a real one points.
#pragma once

#include <glm/vec3.hpp>

namespace voxprite {

// Of all integer vectors with components within +-2^bits, the one at the smallest angle to
// `direction` (finite, not zero), without common divisor. Rays of a view along such a vector stray
// from the true direction by about 2^(-3 bits / 2) instead of the 2^-bits of plain rounding, and
// axis, diagonal and isometric views come out exact: (1,0,0), (1,1,0), (1,1,1). Mirrored or
// exchanged components give mirrored or exchanged results. + - * / alone, so equal on all machines.
[[nodiscard]] glm::ivec3 nearestDirection(glm::dvec3 direction, int bits);

}  // namespace voxprite
