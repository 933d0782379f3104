#include "core/sprite/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "core/base/finite.h"
#include "core/model/range_check.h"

namespace voxprite {

namespace {

// Taylor series; for |x| <= pi/4 the first term left out is below 1e-18.
double sinSeries(double x) {
    const double xx = x * x;
    double sum = 0.0;
    for (int n = 17; n >= 3; n -= 2) sum = (1.0 + sum) * -xx / (n * (n - 1));
    return x + x * sum;
}

double cosSeries(double x) {
    const double xx = x * x;
    double sum = 0.0;
    for (int n = 18; n >= 4; n -= 2) sum = (1.0 + sum) * -xx / (n * (n - 1));
    return 1.0 - 0.5 * xx * (1.0 + sum);
}

// |degrees| <= 45 (an ulp more does no harm).
SinCos reducedSinCos(double degrees) {
    const double size = std::abs(degrees);
    // The isometric and diagonal views are met exactly, so that they keep their symmetry.
    if (size == 45.0) return {std::copysign(std::sqrt(0.5), degrees), std::sqrt(0.5)};
    if (size == 30.0) return {std::copysign(0.5, degrees), std::sqrt(0.75)};
    constexpr double kRadiansPerDegree = 0.017453292519943295;
    const double x = degrees * kRadiansPerDegree;
    return {sinSeries(x), cosSeries(x)};
}

}  // namespace

SinCos sinCosDegrees(double degrees) {
    if (!std::isfinite(degrees)) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    // Both reductions are exact in floating point.
    const double turn = std::fmod(degrees, 360.0);
    const int quarters = static_cast<int>(std::lround(turn / 90.0));
    const SinCos rest = reducedSinCos(turn - 90.0 * quarters);
    switch (((quarters % 4) + 4) % 4) {
        case 1:
            return {rest.cos, 0.0 - rest.sin};
        case 2:
            return {0.0 - rest.sin, -rest.cos};
        case 3:
            return {-rest.cos, rest.sin};
        default:
            return rest;
    }
}

glm::dmat3 orbitBasis(const OrbitAngles& angles) {
    const SinCos yaw = sinCosDegrees(angles.yawDegrees);
    const SinCos pitch = sinCosDegrees(angles.pitchDegrees);
    const SinCos roll = sinCosDegrees(angles.rollDegrees);
    const glm::dvec3 forward{-yaw.sin * pitch.cos, -pitch.sin, -yaw.cos * pitch.cos};
    const glm::dvec3 right{yaw.cos, 0.0, -yaw.sin};
    const glm::dvec3 up{-yaw.sin * pitch.sin, pitch.cos, -yaw.cos * pitch.sin};
    return {right * roll.cos - up * roll.sin, up * roll.cos + right * roll.sin, forward};
}

Camera orbitCamera(const OrbitAngles& angles, glm::dvec3 targetMetres, double distanceMetres,
                   double verticalFovDegrees, glm::ivec2 viewportPx) {
    const glm::dmat3 basis = orbitBasis(angles);
    Camera camera;
    camera.right = basis[0];
    camera.up = basis[1];
    camera.forward = basis[2];
    camera.eyeMetres = targetMetres - basis[2] * distanceMetres;
    camera.verticalFovDegrees = verticalFovDegrees;
    camera.viewportPx = viewportPx;
    return camera;
}

double Camera::metresPerScreenPx(double depthMetres) const {
    if (orthographic) return orthographicHeightMetres / viewportPx.y;
    const SinCos half = sinCosDegrees(0.5 * verticalFovDegrees);
    return 2.0 * depthMetres * (half.sin / half.cos) / viewportPx.y;
}

double Camera::orthographicFarMetres() const {
    return nearMetres + std::max(10'000.0, 256.0 * orthographicHeightMetres);
}

float Camera::reversedDepth(double depthMetres) const {
    if (!orthographic) return static_cast<float>(nearMetres / depthMetres);
    const double far = orthographicFarMetres();
    return static_cast<float>((far - depthMetres) / (far - nearMetres));
}

Camera::Ray Camera::rayFromEye(glm::dvec2 screenPx) const {
    const double metresPerPx = metresPerScreenPx(1.0);
    const glm::dvec2 fromMiddle = (screenPx - glm::dvec2(viewportPx) * 0.5) * metresPerPx;
    const glm::dvec3 across = right * fromMiddle.x - up * fromMiddle.y;
    if (orthographic) return {across, forward};
    return {glm::dvec3(0.0), forward + across};
}

Camera::Ray Camera::rayThrough(glm::dvec2 screenPx) const {
    const Ray ray = rayFromEye(screenPx);
    return {eyeMetres + ray.origin, glm::normalize(ray.direction)};
}

Camera::Projected Camera::project(glm::dvec3 worldMetres) const {
    return projectFromEye(worldMetres - eyeMetres);
}

Camera::Projected Camera::projectFromEye(glm::dvec3 fromEyeMetres) const {
    const double depth = glm::dot(fromEyeMetres, forward);
    const glm::dvec2 across{glm::dot(fromEyeMetres, right), -glm::dot(fromEyeMetres, up)};
    return {glm::dvec2(viewportPx) * 0.5 + across / metresPerScreenPx(depth), depth};
}

glm::dmat4 Camera::clipFromCameraRelative() const {
    // Half of the picture's height and width on the plane at one metre.
    const double halfHeight = 0.5 * viewportPx.y * metresPerScreenPx(1.0);
    const double halfWidth = 0.5 * viewportPx.x * metresPerScreenPx(1.0);
    glm::dvec4 x(right / halfWidth, 0.0);
    glm::dvec4 y(up / halfHeight, 0.0);
    glm::dvec4 z(0.0, 0.0, 0.0, nearMetres);
    glm::dvec4 w(forward, 0.0);
    if (orthographic) {
        const double far = orthographicFarMetres();
        z = glm::dvec4(-forward, far) / (far - nearMetres);
        w = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    }
    return glm::transpose(glm::dmat4(x, y, z, w));
}

Status validate(const Camera& camera) {
    if (!finite(camera.eyeMetres)) return fail("camera: the eye's position is not finite");
    if (!finite(camera.right) || !finite(camera.up) || !finite(camera.forward))
        return fail("camera: its axes are not finite");
    const glm::dmat3 axes(camera.right, camera.up, -camera.forward);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) < 1e-6))
                return fail("camera: right, up and forward are not orthonormal");
    if (glm::determinant(axes) < 0.0) return fail("camera: its axes are mirrored");
    if (camera.viewportPx.x < 1 || camera.viewportPx.y < 1 || camera.viewportPx.x > 32768 ||
        camera.viewportPx.y > 32768)
        return fail("camera: the viewport is " + std::to_string(camera.viewportPx.x) + "x" +
                    std::to_string(camera.viewportPx.y) + ", it must lie within 1 ... 32768");
    if (auto ok = checkRange("camera: the near distance", camera.nearMetres, 1e-9, 1e9); !ok)
        return ok;
    if (camera.orthographic)
        return checkRange("camera: the orthographic height", camera.orthographicHeightMetres, 1e-9,
                          1e12);
    return checkRange("camera: the vertical field of view", camera.verticalFovDegrees, 1.0, 170.0);
}

}  // namespace voxprite
