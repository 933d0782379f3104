#include "app/editor/views/picking.h"

#include <algorithm>
#include <cmath>

#include "core/trace/raycast.h"

namespace voxprite::editor {
namespace {

constexpr int kLeastGroundReach = 64;

IBox groundReach(const IBox& bounds) {
    const glm::ivec3 size = bounds.empty() ? glm::ivec3(0) : bounds.size();
    const int reach = std::max(kLeastGroundReach, std::max(size.x, size.y));
    return {bounds.min - glm::ivec3(reach, reach, 1), bounds.max + glm::ivec3(reach, reach, 1)};
}

std::optional<Pick> pickGround(const IBox& bounds, const Camera::Ray& ray) {
    const int height = bounds.empty() ? 0 : bounds.min.z;
    if (ray.direction.y >= 0.0) return std::nullopt;  // only from above
    const auto hit = meetPlane(ray, 2, height);
    if (!hit) return std::nullopt;
    const IBox reach = groundReach(bounds);
    if (hit->x < reach.min.x || hit->y < reach.min.y || hit->x >= reach.max.x ||
        hit->y >= reach.max.y) {
        return std::nullopt;
    }
    const glm::ivec3 cell(static_cast<int>(std::floor(hit->x)),
                          static_cast<int>(std::floor(hit->y)), height - 1);
    return Pick{cell, {0, 0, 1}, true};
}

}  // namespace

std::optional<glm::dvec3> meetPlane(const Camera::Ray& ray, int axis, double plane) {
    const glm::dvec3 eye = voxelFromWorld(ray.origin);
    const glm::dvec3 direction = voxelFromWorld(ray.direction);
    if (std::abs(direction[axis]) < 1e-9) return std::nullopt;
    const double t = (plane - eye[axis]) / direction[axis];
    if (t <= 0.0) return std::nullopt;
    return eye + direction * t;
}

std::optional<Pick> pick(const LiveOctree& octree, const IBox& bounds, const Camera::Ray& ray) {
    if (!bounds.empty()) {
        const glm::dvec3 eye = voxelFromWorld(ray.origin) - glm::dvec3(bounds.min);
        const glm::dvec3 direction = voxelFromWorld(ray.direction);
        const RaycastHit found = raycast(octree.view(bounds), {eye, direction});
        if (found.hit) return Pick{found.voxel + bounds.min, glm::ivec3(found.normal), false};
    }
    return pickGround(bounds, ray);
}

std::array<glm::dvec3, 4> faceCorners(const Pick& pick) {
    const int axis = pick.axis();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dvec3 corner(pick.voxel);
    corner[axis] = pick.facePlane();
    std::array<glm::dvec3, 4> corners{corner, corner, corner, corner};
    corners[1][u] += 1.0;
    corners[2][u] += 1.0;
    corners[2][v] += 1.0;
    corners[3][v] += 1.0;
    return corners;
}

}  // namespace voxprite::editor
