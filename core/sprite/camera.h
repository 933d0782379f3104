// A camera in the Y-up world, in double precision.
//
// World axes are right-handed, Y up; voxel axes are right-handed, Z up:
//   voxel.x = world.x,  voxel.y = -world.z,  voxel.z = world.y.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/result.h"

namespace voxprite {

[[nodiscard]] inline glm::dvec3 voxelFromWorld(glm::dvec3 w) {
    return {w.x, -w.z, w.y};
}
[[nodiscard]] inline glm::dvec3 worldFromVoxel(glm::dvec3 v) {
    return {v.x, v.z, -v.y};
}

struct Camera {
    glm::dvec3 eyeMetres{0.0, 0.0, 10.0};
    // Orthonormal; the camera looks along `forward`.
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 forward{0, 0, -1};
    bool orthographic = false;
    double verticalFovDegrees = 45.0;        // perspective: 1 ... 170
    double orthographicHeightMetres = 10.0;  // orthographic: the picture's height
    double nearMetres = 0.01;
    glm::ivec2 viewportPx{512, 512};

    // Sizes on the plane at `depth` metres along forward (orthographic: any depth).
    [[nodiscard]] double metresPerScreenPx(double depthMetres) const;
    // The direction (unit) and start of the eye ray through a point of the viewport; (0,0) is the
    // top left corner, pixel centres are at .5.
    struct Ray {
        glm::dvec3 origin, direction;
    };
    [[nodiscard]] Ray rayThrough(glm::dvec2 screenPx) const;
    // The same camera-relative (the eye is the origin), so that nothing is lost far from the
    // world's origin; the direction has length 1 along forward.
    [[nodiscard]] Ray rayFromEye(glm::dvec2 screenPx) const;
    // Screen position (top left origin) of a world point; depth along forward. depth <= 0 is
    // behind.
    struct Projected {
        glm::dvec2 screenPx;
        double depthMetres;
    };
    [[nodiscard]] Projected project(glm::dvec3 worldMetres) const;
    [[nodiscard]] Projected projectFromEye(glm::dvec3 fromEyeMetres) const;
    // Camera-relative: world translated so that the eye is the origin. Reversed Z, zero to one,
    // infinite far plane (perspective) or the one below (orthographic).
    [[nodiscard]] glm::dmat4 clipFromCameraRelative() const;
    // Far enough for any scene of that height, near enough for 32-bit depth.
    [[nodiscard]] double orthographicFarMetres() const;
    // What the depth buffer holds for a depth along forward: 1 at the near plane, 0 at the far.
    [[nodiscard]] float reversedDepth(double depthMetres) const;
};

[[nodiscard]] Status validate(const Camera& camera);

// The camera of the command line: at yaw 0, pitch 0 the eye is on the model's -Y side and looks
// along +Y, Z up (voxel space). Positive yaw carries the eye toward +X, positive pitch raises it,
// positive roll turns the camera clockwise. Exact at multiples of 90; at pitch +-90 the yaw still
// sets the picture's up.
struct OrbitAngles {
    double yawDegrees = 0.0;
    double pitchDegrees = 0.0;
    double rollDegrees = 0.0;
};
// right, up and forward of the orbit, in world axes (columns 0, 1, 2).
[[nodiscard]] glm::dmat3 orbitBasis(const OrbitAngles& angles);
[[nodiscard]] Camera orbitCamera(const OrbitAngles& angles, glm::dvec3 targetMetres,
                                 double distanceMetres, double verticalFovDegrees,
                                 glm::ivec2 viewportPx);

// sin and cos of an angle in degrees, exact at multiples of 90 (and the same on every machine).
struct SinCos {
    double sin, cos;
};
[[nodiscard]] SinCos sinCosDegrees(double degrees);

}  // namespace voxprite
