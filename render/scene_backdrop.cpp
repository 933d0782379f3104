#include "render/scene_backdrop.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/gl/draw_state.h"
#include "render/gpu_blocks.h"

namespace voxprite {

namespace {

constexpr double kGridPeriodMetres = 10.0;
constexpr double kBlobReach = 1.25;  // of the model's footprint
constexpr double kBlobStrength = 0.55;

struct BackdropBlock {
    glm::dvec4 ground_rise{0.0};
    glm::dvec4 ground_descent{0.0};
    glm::dvec4 ground_depth{0.0};
    glm::vec4 ground_colour{0.0f};
    glm::vec4 sky_zenith = kSkyZenith;
    glm::vec4 sky_horizon = kSkyHorizon;
    glm::vec2 eye_on_grid{0.0f};
    float ground_near_metres = 0.0f;
    float haze_metres = 0.0f;
    std::int32_t sky_shown = 0;
    std::int32_t ground_shown = 0;
    std::int32_t grid_shown = 0;
    float padding[5]{};
};
static_assert(sizeof(BackdropBlock) == 192);

struct BlobBlock {
    std::array<glm::vec4, 4> corners{};
    glm::vec4 strength{0.0f};  // x
};
static_assert(sizeof(BlobBlock) == 80);

// The half axes of the ellipse on the ground that is like the shadow of the model's box: those of
// the box, seen from above, added up as a covariance and split again (Cholesky).
struct Footprint {
    glm::dvec2 a{0.0}, b{0.0};  // world x and z, metres
};

Footprint footprintOf(const PlacedEntity& placed) {
    double xx = 0.0;
    double xz = 0.0;
    double zz = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 half =
            placed.worldFromVoxelAxes[axis] *
            (0.5 * placed.modelSize[axis] * placed.metresPerVoxel() * kBlobReach);
        xx += half.x * half.x;
        xz += half.x * half.z;
        zz += half.z * half.z;
    }
    const double a = std::sqrt(std::max(xx, 1e-30));
    const double across = xz / a;
    return {{a, across}, {0.0, std::sqrt(std::max(zz - across * across, 0.0))}};
}

std::optional<BlobBlock> blobUnder(const PlacedEntity& placed, const Ground& ground,
                                   const Camera& camera, const glm::dmat4& clipFromEye) {
    const glm::dvec3 centre = placed.centreMetres();
    const double radius = placed.radiusMetres();
    // The higher the model, the fainter: gone where it hovers two of its own heights up.
    const double hover = (centre.y - ground.heightMetres) / std::max(radius, 1e-9);
    const double strength = kBlobStrength * std::clamp(1.5 - 0.5 * hover, 0.0, 1.0);
    if (hover < -1.0 || strength <= 0.0) return std::nullopt;
    const Footprint footprint = footprintOf(placed);
    const glm::dvec3 middle(centre.x - camera.eyeMetres.x, ground.heightMetres - camera.eyeMetres.y,
                            centre.z - camera.eyeMetres.z);
    BlobBlock block;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const glm::dvec2 along = footprint.a * ((corner & 1) != 0 ? 1.0 : -1.0) +
                                 footprint.b * ((corner & 2) != 0 ? 1.0 : -1.0);
        const glm::dvec3 point = middle + glm::dvec3(along.x, 0.0, along.y);
        block.corners[corner] = glm::vec4(clipFromEye * glm::dvec4(point, 1.0));
    }
    block.strength.x = static_cast<float>(strength);
    return block;
}

}  // namespace

void SceneBackdrop::draw(const Scene& scene, const Camera& camera) {
    if (isEmpty(scene)) return;
    glBindVertexArray(nothing_.id());
    drawPlane(scene, camera);
    // Shadows lie on the ground: seen from below there is nothing to lie on.
    if (!scene.ground || !scene.shadowBlobs || camera.eyeMetres.y <= scene.ground->heightMetres) {
        return;
    }
    drawBlobs(scene, camera);
}

void SceneBackdrop::drawPlane(const Scene& scene, const Camera& camera) {
    cameraBlock_.set(BlockBinding::camera, cameraBlock(camera));
    BackdropBlock block;
    if (scene.ground) {
        const EyeRays rays = eyeRays(camera);
        const double height = scene.ground->heightMetres - camera.eyeMetres.y;
        block.ground_rise = glm::dvec4(-rays.originPerX.y, -rays.originPerY.y, height, 0.0);
        block.ground_descent =
            glm::dvec4(rays.directionPerX.y, rays.directionPerY.y, rays.direction.y, 0.0);
        block.ground_depth = depthFromMetres(camera);
        block.ground_colour = toVec4(scene.ground->colour);
        block.eye_on_grid = glm::vec2(std::fmod(camera.eyeMetres.x, kGridPeriodMetres),
                                      std::fmod(camera.eyeMetres.z, kGridPeriodMetres));
        block.ground_near_metres = static_cast<float>(camera.nearMetres);
        block.haze_metres = scene.sky ? kHazeMetres : 0.0f;
        block.ground_shown = 1;
        block.grid_shown = scene.groundGrid ? 1 : 0;
    }
    block.sky_shown = scene.sky ? 1 : 0;
    backdropBlock_.set(BlockBinding::backdrop, block);
    gl::apply({.depthWrite = true});
    plane_.useOrSay();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SceneBackdrop::drawBlobs(const Scene& scene, const Camera& camera) {
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    std::vector<BlobBlock> blobs;
    blobs.reserve(scene.entities.size());
    for (const SceneEntity& entity : scene.entities) {
        if (const auto blob = blobUnder(entity.shadow ? *entity.shadow : entity.placed,
                                        *scene.ground, camera, clipFromEye)) {
            blobs.push_back(*blob);
        }
    }
    if (blobs.empty()) return;
    blobs_.set(BufferBinding::blobs, std::span<const BlobBlock>(blobs));
    gl::apply({.blend = true});
    blob_.useOrSay();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(blobs.size()));
}

}  // namespace voxprite
