#include "app/editor/views/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace voxprite::editor {
namespace {

constexpr double kDegreesPerPx = 0.4;
constexpr double kZoomPerNotch = 0.87;
constexpr double kMinDistance = 1e-4;
constexpr double kMaxDistance = 1e9;
// Without perspective the eye can stand back where nothing of a model is behind it.
constexpr double kParallelStandoff = 4096.0;

// Half of what a view shows, a metre away.
double halfHeightPerMetre() {
    return std::tan(kViewFovDegrees * 0.5 * std::acos(-1.0) / 180.0);
}

}  // namespace

Camera OrbitCamera::camera(glm::ivec2 viewportPx) const {
    const double eyeDistance =
        orthographic ? std::max(4.0 * distance, kParallelStandoff) : distance;
    Camera camera = orbitCamera({yawDegrees, pitchDegrees, 0.0}, target, eyeDistance,
                                kViewFovDegrees, viewportPx);
    camera.nearMetres = distance * 1e-3;
    camera.orthographic = orthographic;
    camera.orthographicHeightMetres = 2.0 * distance * halfHeightPerMetre();
    return camera;
}

void OrbitCamera::orbit(glm::dvec2 movedPx) {
    yawDegrees = std::remainder(yawDegrees - movedPx.x * kDegreesPerPx, 360.0);
    pitchDegrees = std::clamp(pitchDegrees + movedPx.y * kDegreesPerPx, -90.0, 90.0);
}

void OrbitCamera::pan(glm::dvec2 movedPx, glm::ivec2 viewportPx) {
    const Camera now = camera(viewportPx);
    const double step = now.metresPerScreenPx(distance);
    target += (-movedPx.x * now.right + movedPx.y * now.up) * step;
}

void OrbitCamera::lookFrom(glm::dvec3 toward) {
    const double level = std::hypot(toward.x, toward.y), degrees = 180.0 / std::acos(-1.0);
    pitchDegrees = std::atan2(toward.z, level) * degrees;
    yawDegrees = level > 0.0 ? std::atan2(toward.x, -toward.y) * degrees
                             : 90.0 * std::round(yawDegrees / 90.0);
}

void OrbitCamera::zoom(double notches, glm::dvec2 pointerPx, glm::ivec2 viewportPx) {
    const double wanted = distance * std::pow(kZoomPerNotch, notches);
    const double factor = std::clamp(wanted, kMinDistance, kMaxDistance) / distance;
    const Camera now = camera(viewportPx);
    const glm::dvec2 fromCentre = pointerPx - glm::dvec2(viewportPx) * 0.5;
    const glm::dvec3 under = target + (fromCentre.x * now.right - fromCentre.y * now.up) *
                                          now.metresPerScreenPx(distance);
    target = under + (target - under) * factor;
    distance *= factor;
}

void OrbitCamera::lookLike(const OrbitCamera& other, const PlacedEntity& there,
                           const PlacedEntity& here) {
    const double unit = here.metresPerVoxel() / there.metresPerVoxel();
    const glm::dvec3 fromCentre =
        glm::transpose(there.worldFromVoxelAxes) * (other.target - there.centreMetres());
    target = here.centreMetres() + here.worldFromVoxelAxes * fromCentre * unit;
    yawDegrees = other.yawDegrees;
    pitchDegrees = other.pitchDegrees;
    distance = other.distance * unit;
    orthographic = other.orthographic;
}

void OrbitCamera::frame(std::span<const glm::dvec3> points, double air, glm::ivec2 viewportPx) {
    if (points.empty()) return;
    glm::dvec3 least = points.front(), most = points.front();
    for (const glm::dvec3 point : points) {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    target = (least + most) * 0.5;
    const Camera now = camera(viewportPx);
    const glm::dvec2 size = glm::max(glm::dvec2(viewportPx), glm::dvec2(1.0));
    const double up = halfHeightPerMetre() / (1.0 + air);
    const double across = up * size.x / size.y;
    double needed = kMinDistance;
    for (const glm::dvec3 point : points) {
        const glm::dvec3 from = point - target;
        const double depth = orthographic ? 0.0 : glm::dot(from, now.forward);
        needed = std::max({needed, std::abs(glm::dot(from, now.right)) / across - depth,
                           std::abs(glm::dot(from, now.up)) / up - depth});
    }
    distance = std::min(needed, kMaxDistance);
}

}  // namespace voxprite::editor
