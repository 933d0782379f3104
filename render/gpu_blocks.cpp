#include "render/gpu_blocks.h"

namespace voxprite {

EyeRays eyeRays(const Camera& camera) {
    const double step = camera.metresPerScreenPx(1.0);
    EyeRays rays;
    rays.direction = camera.forward;
    glm::dvec3& perX = camera.orthographic ? rays.originPerX : rays.directionPerX;
    glm::dvec3& perY = camera.orthographic ? rays.originPerY : rays.directionPerY;
    perX = camera.right * step;
    perY = camera.up * step;
    return rays;
}

glm::dvec4 depthFromMetres(const Camera& camera) {
    const glm::dmat4 clip = camera.clipFromCameraRelative();
    const glm::dvec4 perMetre = clip * glm::dvec4(camera.forward, 0.0);
    const glm::dvec4 atEye = clip[3];
    return {perMetre.z, atEye.z, perMetre.w, atEye.w};
}

CameraBlock cameraBlock(const Camera& camera) {
    const EyeRays rays = eyeRays(camera);
    CameraBlock block;
    block.ray_origin = {toVec4(rays.originPerX), toVec4(rays.originPerY), glm::vec4(0.0f)};
    block.ray_direction = {toVec4(rays.directionPerX), toVec4(rays.directionPerY),
                           toVec4(rays.direction)};
    block.viewport_px = glm::vec2(camera.viewportPx);
    return block;
}

}  // namespace voxprite
