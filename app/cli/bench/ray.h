// Rays through the box of a model, as the rivals take them.
#pragma once

#include <glm/vec3.hpp>

namespace voxprite::bench {

// A ray in voxels from the minimum corner; `direction` of any length. Only t >= tMin counts.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 1.0, 0.0};
    double tMin = 0.0;
};

// Where the ray is inside the box [0, size]; tIn > tOut when it never is.
struct Span {
    double tIn, tOut;
};
[[nodiscard]] Span clip(const Ray& ray, glm::ivec3 size);
// The cell of the box that the ray is in at t.
[[nodiscard]] glm::ivec3 cellAt(const Ray& ray, double t, glm::ivec3 size);

}  // namespace voxprite::bench
