// Neither infinite nor NaN.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace voxprite {

[[nodiscard]] inline bool finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace voxprite
