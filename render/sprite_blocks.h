// What the shaders of sprites read: the structs of shaders/shared/sprite.glsl.
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
#include "render/octree_arena.h"

namespace voxprite {

// Sprite
struct SpriteBlock {
    std::array<glm::vec4, 3> pixel_from_screen{};
    glm::vec2 screen_reference{0.0f};
    glm::ivec2 region_size{0};
    glm::ivec3 atlas_place{0};
    std::int32_t palette_row = 0;
    glm::ivec3 lattice_origin{0};
    std::int32_t position_bits = 8;
    glm::ivec3 lattice_right{0};
    std::int32_t first_x = 0;
    glm::ivec3 lattice_up{0};
    std::int32_t first_y = 0;
    glm::ivec3 lattice_direction{0};
    std::uint32_t svo_max_depth = 1;
    glm::uvec3 svo_model_size{0};
    std::uint32_t node_offset = 0;
    glm::ivec3 tree_from_voxel{0};
    std::uint32_t payload_offset = 0;
    glm::vec4 depth_per_step{0.0f};
    glm::vec3 ray_dir_local{0.0f};
    float voxel_size = 0.1f;
    glm::vec3 camera_up_local{0.0f};
    float sigma = 4.0f;
    glm::vec3 anchor_to_center{0.0f};
    float billboard_depth = 0.0f;
    glm::vec3 light_dir{0.0f};
    float camera_distance = 1.0f;
};
static_assert(sizeof(SpriteBlock) == 256);

// The corners of the region to draw, in clip space: a quad's four, or a box's eight.
using SpriteCorners = std::array<glm::vec4, 8>;

// SpriteDraw
struct SpriteDrawBlock {
    glm::vec4 depth_from_metres{0.0f};
    glm::vec2 target_size{0.0f};
    std::uint32_t outline_colour = 0xFF00'0000u;
    std::int32_t outline_enabled = 1;
    std::int32_t first_sprite = 0;
    std::int32_t sprite_count = 0;
    std::int32_t occlusion_shown = 0;
    std::int32_t shadows_shown = 0;
};
static_assert(sizeof(SpriteDrawBlock) == 48);

// Can the shaders cast these rays in plain ints? All products must fit, and positions stay below
// 2^22 steps, so that a quotient taken in single precision is off by one at most.
[[nodiscard]] bool castsNarrow(const LatticeView& lattice, glm::ivec3 modelSize);

// What casting `lattice` needs; its first pixel is the cell (0, 0), and shadow rays run toward
// `towardLight` (FaceRays). The octree and the palette are where `placeInputs` puts them.
[[nodiscard]] SpriteBlock castBlock(const LatticeView& lattice, const GpuOctree& octree,
                                    glm::ivec3 towardLight);
void placeInputs(SpriteBlock& block, const OctreePlace& octree, int paletteRow);

// For drawing `visible`, the part of view.lattice to show, onto the screen; all but its place in
// the atlas.
[[nodiscard]] SpriteBlock screenBlock(const SpriteView& view, const LatticeView& visible,
                                      const PlacedEntity& placed, const GpuOctree& octree,
                                      const Camera& camera);
[[nodiscard]] SpriteCorners screenCorners(const SpriteView& view, const LatticeView& visible,
                                          const Camera& camera);

// The look that all sprites of a draw share.
struct SpriteLook {
    Outline outline;
    bool occlusion = false, shadows = false;  // do faces cast these rays?

    explicit SpriteLook(const GameProfile& profile)
        : outline(profile.outline),
          occlusion(hasOcclusion(profile.light)),
          shadows(hasShadows(profile.light)) {}
    explicit SpriteLook(const LitPalette& lit)
        : outline(lit.outline), occlusion(lit.rays.occlusion), shadows(lit.rays.shadows()) {}
    [[nodiscard]] bool castsFromFaces() const { return occlusion || shadows; }
};
[[nodiscard]] SpriteDrawBlock drawBlock(const SpriteLook& look);

}  // namespace voxprite
