#include "app/cli/bench/ray.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace voxprite::bench {

Span clip(const Ray& ray, glm::ivec3 size) {
    Span span{ray.tMin, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < 0.0 || ray.origin[axis] >= size[axis]) return {1.0, 0.0};
            continue;
        }
        const double a = -ray.origin[axis] / ray.direction[axis];
        const double b = (size[axis] - ray.origin[axis]) / ray.direction[axis];
        span.tIn = std::max(span.tIn, std::min(a, b));
        span.tOut = std::min(span.tOut, std::max(a, b));
    }
    return span;
}

glm::ivec3 cellAt(const Ray& ray, double t, glm::ivec3 size) {
    return glm::clamp(glm::ivec3(glm::floor(ray.origin + ray.direction * t)), glm::ivec3(0),
                      size - 1);
}

}  // namespace voxprite::bench
