// castPerspective of core/trace/lattice_caster.h.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/trace/lattice_caster.h"
#include "core/trace/octree_walk.h"

namespace voxprite {
namespace {

// What keys may spend on the root's edge, positions and twice the direction: of 64 bits go off the
// sign, two for the axis, one for starts beside the root, and one so that kNever stays larger.
constexpr int kKeyBits = 59;

}  // namespace

PerspectiveHit castPerspective(const OctreeView& octree, glm::dvec3 eye, glm::dvec3 direction) {
    const IBox box = castableBox(octree);
    const auto finite = [](glm::dvec3 v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    if (box.empty() || !finite(eye) || !finite(direction)) return {};
    int largest = 0;
    for (int a = 1; a < 3; ++a)
        if (std::abs(direction[a]) > std::abs(direction[largest])) largest = a;
    if (direction[largest] == 0.0) return {};
    const glm::dvec3 scaled = direction / std::abs(direction[largest]);

    // Where the ray enters the box, if the eye is outside.
    bool inside = true;
    double enter = 0.0;
    for (int a = 0; a < 3; ++a) {
        const bool below = eye[a] < box.min[a];
        const bool above = eye[a] >= box.max[a];
        if (!below && !above) continue;
        inside = false;
        if (below ? scaled[a] <= 0.0 : scaled[a] >= 0.0) return {};
        enter = std::max(enter, ((below ? box.min[a] : box.max[a]) - eye[a]) / scaled[a]);
    }
    const glm::dvec3 start = eye + scaled * enter;

    LatticeRay ray;
    ray.positionBits = std::max(8, 21 - octree.maxDepth);
    const int directionBits = (kKeyBits - octree.maxDepth - ray.positionBits) / 2;
    for (int a = 0; a < 3; ++a) {
        // Rounding moves the line by far less than a voxel: it would miss as well.
        if (!(start[a] >= box.min[a] - 1.0 && start[a] <= box.max[a] + 1.0)) return {};
        ray.origin[a] = std::llround(std::ldexp(start[a], ray.positionBits));
        ray.direction[a] = static_cast<int>(std::lround(std::ldexp(scaled[a], directionBits)));
    }

    const Course course(octree, ray.direction, ray.positionBits);
    const Line line(course, ray.origin);
    // From inside, every crossing up to the eye (time 0) has been made; axis 3 stands for the eye.
    constexpr std::int64_t kAtEye = 3;
    PerspectiveHit result;
    result.hit = walk(course, line, inside ? std::max(line.enter, kAtEye) : line.enter);
    if (result.hit.material == 0) return result;
    if (result.hit.faceAxis == kAtEye) {
        result.hit.faceAxis = static_cast<std::uint8_t>(largest);
        return result;
    }
    const int axis = result.hit.faceAxis;
    const int face = result.hit.voxel[axis] + (direction[axis] < 0.0 ? 1 : 0);
    result.t = std::max(0.0, (face - eye[axis]) / scaled[axis]) * glm::length(scaled);
    return result;
}

}  // namespace voxprite
