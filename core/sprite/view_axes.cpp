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

// Of a step: so far past the middle between two steps an angle keeps the old one.
constexpr double kSnapMargin = 0.1;
constexpr double kMostSnapMargin = 1.0;

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

// The yaw of the view from straight above (or below) that is nearest to these axes.
double headingAtPole(const glm::dmat3& voxelAxes, bool above) {
    const glm::dvec3 right = voxelAxes[0];
    const glm::dvec3 up = above ? voxelAxes[1] : -voxelAxes[1];
    return glm::degrees(std::atan2(right.y - up.x, right.x + up.y));
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
    const double stepsPer45 = std::max(1.0, std::round(45.0 / stepDegrees));
    const auto degreesOf = [&](int steps) { return steps * 45.0 / stepsPer45; };
    const std::optional<glm::ivec3> before =
        history != nullptr ? history->snappedSteps : std::nullopt;
    const auto snapped = [&](double degrees, int axis, double margin) {
        const auto nearest = static_cast<int>(std::lround(degrees * stepsPer45 / 45.0));
        if (!before) return nearest;
        // The shorter way round, for yaw and roll.
        const double turn = std::remainder(degrees - degreesOf((*before)[axis]), 360.0);
        return std::abs(turn) <= (0.5 + margin) * degreesOf(1) ? (*before)[axis] : nearest;
    };

    OrbitAngles angles = orbitAnglesOf(voxelAxes);
    // The nearer to the pole, the more a move of the eye turns the picture.
    const double towardPole = std::hypot(voxelAxes[2].x, voxelAxes[2].y);
    const double margin = std::min(kSnapMargin / towardPole, kMostSnapMargin);
    const int pitch = snapped(angles.pitchDegrees, 1, kSnapMargin);
    // Seen from the pole yaw and roll are one turn: apart, each would have a step of its own.
    const bool atPole = std::abs(degreesOf(pitch)) == 90.0;
    if (atPole) angles = {headingAtPole(voxelAxes, pitch > 0), degreesOf(pitch), 0.0};
    const glm::ivec3 steps{snapped(angles.yawDegrees, 0, margin), pitch,
                           atPole ? 0 : snapped(angles.rollDegrees, 2, margin)};
    if (history != nullptr) history->snappedSteps = steps;
    return voxelAxesOf({degreesOf(steps.x), degreesOf(steps.y), degreesOf(steps.z)});
}

glm::dmat3 rolledToMatch(const glm::dmat3& plane, const glm::dmat3& seen, const glm::dmat3& shown,
                         glm::ivec3 boxSize) {
    // Procrustes in the plane (Kabsch 1976), from the second moments of the box: its axes are
    // independent, each with the square of its edge.
    const glm::dvec3 edges(boxSize);
    const glm::dvec3 right = shown[0] * edges * edges;
    const glm::dvec3 up = shown[1] * edges * edges;
    const double sine = glm::dot(right, seen[1]) - glm::dot(up, seen[0]);
    const double cosine = glm::dot(right, seen[0]) + glm::dot(up, seen[1]);
    const double size = std::hypot(sine, cosine);
    constexpr double kSame = 1e-9;
    if (!(size > 0.0) || (std::abs(sine) < kSame * size && cosine > 0.0)) return plane;
    const double s = sine / size;
    const double c = cosine / size;
    return {plane[0] * c + plane[1] * s, plane[1] * c - plane[0] * s, plane[2]};
}

double angleBetween(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace voxprite
