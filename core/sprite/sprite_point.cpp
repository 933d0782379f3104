#include "core/sprite/sprite_point.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/trace/raycast.h"

namespace voxprite {
namespace {

bool seen(const OctreeView& octree, glm::dvec3 point, glm::dvec3 forward) {
    constexpr double kTouching = 1e-3;  // voxels: rays are quantised
    const glm::dvec3 size(octree.size);
    // Before the model, wherever the point is.
    const double back = glm::length(point - size * 0.5) + glm::length(size) + 1.0;
    const RaycastHit hit = raycast(octree, {point - forward * back, forward});
    if (!hit.hit || hit.t >= back - kTouching) return true;
    const glm::dvec3 inVoxel = point - glm::dvec3(hit.voxel);
    return inVoxel.x > 0.0 && inVoxel.x < 1.0 && inVoxel.y > 0.0 && inVoxel.y < 1.0 &&
           inVoxel.z > 0.0 && inVoxel.z < 1.0;
}

}  // namespace

SpritePoint locateInSprite(const LatticeView& lattice, const OctreeView& octree, glm::dvec3 point) {
    // Ray (i, j) runs through C + (i U + j V) / 2^shift + s D, half a step before it on average,
    // because its start is rounded down.
    const double stepsPerVoxel = std::ldexp(1.0, lattice.positionBits);
    const glm::dvec3 start = glm::dvec3(lattice.C) - 0.5;
    const glm::dmat3 steps(glm::dvec3(lattice.U) * std::ldexp(1.0, -kStepShift),
                           glm::dvec3(lattice.V) * std::ldexp(1.0, -kStepShift),
                           glm::dvec3(lattice.D));
    const glm::dvec3 at = glm::inverse(steps) * (point * stepsPerVoxel - start);
    const glm::dvec2 first(lattice.first);
    // Samples lie in the middle of their pixels; rows count from the top.
    const glm::dvec2 fromCorner = glm::dvec2(at.x, at.y) - first + 0.5;
    return {{fromCorner.x, lattice.size.y - fromCorner.y},
            seen(octree, point, glm::normalize(glm::dvec3(lattice.D)))};
}

}  // namespace voxprite
