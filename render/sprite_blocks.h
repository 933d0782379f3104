// What the shaders of sprites read: LatticeBlock and Sprite of shaders/shared.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/model/game_profile.h"
#include "core/sprite/sprite_view.h"
#include "core/trace/lattice.h"
#include "render/gpu_octree.h"

namespace voxprite {

struct LatticeBlock {
    glm::ivec3 lattice_origin{0};
    std::int32_t position_bits = 8;
    glm::ivec3 lattice_right{0};
    std::int32_t first_x = 0;
    glm::ivec3 lattice_up{0};
    std::int32_t first_y = 0;
    alignas(16) glm::ivec3 lattice_direction{0};
    alignas(16) glm::ivec3 mirror_sign{1};
    alignas(16) glm::ivec3 mirror_bits{0};
    alignas(16) glm::ivec3 box_low{0};
    alignas(16) glm::ivec3 box_high{0};
    alignas(16) glm::ivec3 box_centre{0};
};
static_assert(sizeof(LatticeBlock) == 144);

struct SpriteBlock {
    std::array<glm::vec4, 8> corners{};
    std::array<glm::vec4, 3> pixel_from_screen{};
    glm::vec2 screen_reference{0.0f};
    glm::ivec2 region_size{0};
    glm::vec4 outline_colour{0.0f, 0.0f, 0.0f, 1.0f};
    std::int32_t outline_enabled = 1;
    std::int32_t proxy_is_box = 0;
    float billboard_depth = 0.0f;
    float camera_distance = 1.0f;
    glm::vec4 depth_per_step{0.0f};
    glm::vec4 depth_from_metres{0.0f};
    glm::vec3 ray_dir_local{0.0f};
    float voxel_size = 0.1f;
    glm::vec3 camera_up_local{0.0f};
    float sigma = 4.0f;
    alignas(16) glm::vec3 anchor_to_center{0.0f};
    alignas(16) glm::vec3 light_dir{0.0f};
    alignas(16) glm::ivec3 lattice_origin{0};
    std::int32_t position_bits = 8;
    glm::ivec3 lattice_right{0};
    std::int32_t first_x = 0;
    glm::ivec3 lattice_up{0};
    std::int32_t first_y = 0;
    glm::ivec3 lattice_direction{0};
    alignas(16) glm::uvec3 svo_model_size{0};
    alignas(16) glm::ivec3 atlas_place{0};
};
static_assert(sizeof(SpriteBlock) == 416);

// The lattice as the shaders cast it: mirrored, from the centre corner. Its first pixel is the
// fragment at (0, 0).
[[nodiscard]] LatticeBlock latticeBlock(const LatticeView& lattice, const GpuOctree& octree);

// Can the shaders cast these rays in plain ints? All products must fit, and positions stay below
// 2^22 steps, so that a quotient taken in single precision is off by one at most.
[[nodiscard]] bool castsNarrow(const LatticeView& lattice, glm::ivec3 modelSize);

// For drawing `lattice` into a buffer of its own, one fragment a virtual pixel.
[[nodiscard]] SpriteBlock bufferBlock(const LatticeView& lattice, const Outline& outline);

// For drawing onto the screen. `visible` is the part of view.lattice to show.
[[nodiscard]] SpriteBlock screenBlock(const SpriteView& view, const LatticeView& visible,
                                      const PlacedEntity& placed, const Camera& camera,
                                      const GameProfile& profile);

}  // namespace voxprite
