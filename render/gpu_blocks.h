// The uniform blocks of shaders/shared, mirrored member by member (std140), and what fills them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/base/image.h"
#include "core/sprite/camera.h"

namespace voxprite {

// binding = N of each block of uniforms
enum class BlockBinding : std::uint32_t {
    octree = 0,
    spriteDraw = 2,
    camera = 3,
    backdrop = 4,
    occlusionRays = 5,
    voxelView = 6,
    overlay = 7,
    clusterCut = 8,
    clusterDraw = 9,
    snapshotDraw = 10
};

// binding = N of each buffer: below 8, which is what OpenGL promises. Some are shared by buffers
// that no program reads together.
enum class BufferBinding : std::uint32_t {
    sprites = 0,
    spriteCorners = 1,
    blobs = 2,
    clusterPages = 3,
    clusterCuts = 4,
    clusterCommands = 5,
    snapshots = 6,
    castTiles = 1,
    rays = 3,
    rayHits = 4
};

// binding = N of each texture
enum class TextureUnit : std::uint32_t {
    svo = 0,
    palette = 1,
    spriteColours = 2,
    spriteIds = 3,
    snapshotColours = 4,
    snapshotDepths = 5
};

// binding = N of each image
enum class ImageUnit : std::uint32_t { sprites = 0 };

struct OctreeBlock {
    glm::uvec3 svo_model_size{0};
    std::uint32_t svo_max_depth = 1;
    glm::ivec3 tree_from_voxel{0};
    std::uint32_t node_offset = 0;
    std::uint32_t payload_offset = 0;
    std::array<std::uint32_t, 3> padding{};
};
static_assert(sizeof(OctreeBlock) == 48);

struct CameraBlock {
    std::array<glm::vec4, 3> ray_origin{};
    std::array<glm::vec4, 3> ray_direction{};
    glm::vec2 viewport_px{0.0f};
    std::array<float, 2> padding{};
};
static_assert(sizeof(CameraBlock) == 112);

// Eye rays of a camera as functions of the screen position (pixels from the viewport's middle, y
// up), in metres from the eye along world axes; directions advance one metre of depth.
struct EyeRays {
    glm::dvec3 originPerX{0.0}, originPerY{0.0};
    glm::dvec3 directionPerX{0.0}, directionPerY{0.0}, direction{0.0};
};
[[nodiscard]] EyeRays eyeRays(const Camera& camera);

// depth = (x * metres + y) / (z * metres + w) for what is `metres` ahead of the eye.
[[nodiscard]] glm::dvec4 depthFromMetres(const Camera& camera);

[[nodiscard]] CameraBlock cameraBlock(const Camera& camera);

[[nodiscard]] inline glm::vec4 toVec4(glm::dvec3 v, double w = 0.0) {
    return glm::vec4(glm::dvec4(v, w));
}
[[nodiscard]] inline glm::vec4 toVec4(Rgba8 colour) {
    return glm::vec4(colour) / 255.0f;
}

}  // namespace voxprite
