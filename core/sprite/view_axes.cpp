#include "core/sprite/view_axes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace voxprite {

namespace {

// Below this sine of the angle between up and ray, up decides nothing.
constexpr double kParallel = 1e-6;
// With a last good basis at hand it is kept this near to the pole (half a degree): there the
// smallest move of the camera turns the picture by any angle.
constexpr double kNearPole = 0.01;

constexpr double kSnapMargin = 0.1;  // of a step

// `side` made perpendicular to `forward`, if that leaves enough of it.
std::optional<glm::dvec3> perpendicular(glm::dvec3 side, glm::dvec3 forward) {
    const glm::dvec3 rest = side - forward * glm::dot(side, forward);
    const double length = glm::length(rest);
    if (length < 0.1) return std::nullopt;
    return rest / length;
}

glm::dvec3 rightOf(const PlacedEntity& entity, const Camera& camera, glm::dvec3 forward,
                   const ViewHistory* history) {
    const bool remembers = history != nullptr && history->basis;
    const glm::dvec3 natural = glm::cross(forward, entity.worldFromVoxelAxes[2]);
    const double sine = glm::length(natural);
    if (sine > (remembers ? kNearPole : kParallel)) return natural / sine;
    if (remembers)
        if (auto kept = perpendicular(entity.worldFromVoxelAxes * (*history->basis)[0], forward))
            return *kept;
    if (auto fromCamera = perpendicular(camera.right, forward)) return *fromCamera;
    return glm::normalize(glm::cross(forward, camera.up));
}

glm::dmat3 voxelAxesOf(const OrbitAngles& angles) {
    const glm::dmat3 world = orbitBasis(angles);
    return {voxelFromWorld(world[0]), voxelFromWorld(world[1]), voxelFromWorld(world[2])};
}

}  // namespace

glm::dmat3 planeAxes(const PlacedEntity& entity, const Camera& camera, ViewRule rule,
                     glm::dvec3 centreFromEyeMetres, ViewHistory* history) {
    glm::dmat3 axes(camera.right, camera.up, camera.forward);
    if (rule == ViewRule::towardEntity) {
        // Eye rays of an orthographic camera are parallel: the one to the entity runs forward too.
        const glm::dvec3 forward =
            camera.orthographic ? camera.forward : glm::normalize(centreFromEyeMetres);
        const glm::dvec3 right = rightOf(entity, camera, forward, history);
        axes = {right, glm::cross(right, forward), forward};
    }
    if (history != nullptr) history->basis = glm::transpose(entity.worldFromVoxelAxes) * axes;
    return axes;
}

OrbitAngles orbitAnglesOf(const glm::dmat3& voxelAxes) {
    const glm::dvec3 towardEye = -voxelAxes[2];
    OrbitAngles angles;
    angles.pitchDegrees = glm::degrees(std::asin(std::clamp(towardEye.z, -1.0, 1.0)));
    if (std::hypot(towardEye.x, towardEye.y) < kParallel) {
        // Straight from above or below the yaw sets the picture's up, and there is no roll.
        const glm::dvec3 up = towardEye.z > 0.0 ? voxelAxes[1] : -voxelAxes[1];
        angles.yawDegrees = glm::degrees(std::atan2(-up.x, up.y));
        return angles;
    }
    angles.yawDegrees = glm::degrees(std::atan2(towardEye.x, -towardEye.y));
    const glm::dmat3 upright = voxelAxesOf(angles);
    angles.rollDegrees = glm::degrees(
        std::atan2(glm::dot(voxelAxes[1], upright[0]), glm::dot(voxelAxes[1], upright[1])));
    return angles;
}

glm::dmat3 snapAxes(const glm::dmat3& voxelAxes, double stepDegrees, ViewHistory* history) {
    const OrbitAngles angles = orbitAnglesOf(voxelAxes);
    const glm::dvec3 exact =
        glm::dvec3(angles.yawDegrees, angles.pitchDegrees, angles.rollDegrees) / stepDegrees;
    glm::ivec3 steps{0};
    for (int axis = 0; axis < 3; ++axis) {
        steps[axis] = static_cast<int>(std::lround(exact[axis]));
        if (history == nullptr || !history->snappedSteps) continue;
        // The shorter way round, for yaw and roll.
        const int before = (*history->snappedSteps)[axis];
        const double turn = std::remainder((exact[axis] - before) * stepDegrees, 360.0);
        if (std::abs(turn) <= (0.5 + kSnapMargin) * stepDegrees) steps[axis] = before;
    }
    if (history != nullptr) history->snappedSteps = steps;
    return voxelAxesOf({steps.x * stepDegrees, std::clamp(steps.y * stepDegrees, -90.0, 90.0),
                        steps.z * stepDegrees});
}

}  // namespace voxprite
