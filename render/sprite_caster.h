// Sprite buffers on the GPU: one ray a virtual pixel, then the outline by dilation.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/sprite/sprite_buffer.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/gpu_octree.h"
#include "render/lit_rows.h"
#include "render/occlusion_rays.h"
#include "render/scene_renderer.h"
#include "render/sprite_programs.h"

namespace voxprite {

// A sprite buffer in textures (bottom row first), which may be larger than the sprite.
struct SpriteTextures {
    gl::Texture colours;  // R32UI: words of RGBA8
    gl::Texture ids;      // R32UI, if wanted
    glm::ivec2 capacity{0};

    SpriteTextures() = default;
    SpriteTextures(glm::ivec2 size, bool withIds);
};

// Both textures to draw into.
struct SpriteTarget {
    SpriteTextures textures;
    gl::Framebuffer framebuffer;

    explicit SpriteTarget(glm::ivec2 size);
};

// A sprite to cast: block.region_size pixels into `framebuffer` at block.atlas_place.
struct CastJob {
    SpriteBlock block;
    std::uint32_t framebuffer = 0;
    std::uint32_t octreeTexture = 0;
    bool narrow = true;
};

class SpriteCaster {
  public:
    // A buffer of this size as one texture each: fails beyond the driver's limit.
    [[nodiscard]] static Status checkSize(glm::ivec2 size);

    // All finished sprites, in few draws: for each framebuffer one with rays and one for outlines.
    // Framebuffers hold R32UI, twice `withIds`. Changes the order of the jobs.
    [[nodiscard]] Status cast(std::vector<CastJob>& jobs, std::uint32_t litRows,
                              const SpriteLook& look, bool withIds);

    // The whole buffer read back, by either mode.
    [[nodiscard]] Result<SpriteBuffer> castBuffer(const GpuOctree& octree,
                                                  const LatticeView& lattice, const LitPalette& lit,
                                                  SpriteMode mode);

  private:
    // A part of the jobs, by place in the buffer.
    struct Run {
        std::size_t first, end;
    };
    [[nodiscard]] Status castInto(const std::vector<CastJob>& jobs, Run run, SpriteDrawBlock block,
                                  bool withIds);
    [[nodiscard]] Status castSinglePass(const CastJob& job, std::uint32_t litRows,
                                        const SpriteLook& look, const SpriteTarget& target);
    // The rays of jobs of one octree and one kind of lattice, into the scratch buffer.
    [[nodiscard]] Status castRays(const std::vector<CastJob>& jobs, Run part, SpriteDrawBlock block,
                                  bool withIds);
    void needScratch(glm::ivec2 size, bool withIds);

    SpriteProgram cast_{"sprite_cast.comp"};
    SpriteProgram outline_{"sprite_region.vert", "sprite_outline.frag"};
    SpriteProgram single_{"sprite_quad.vert", "sprite_single.frag"};
    SpriteShapes shapes_;
    gl::UniformBuffer castBlock_;
    gl::StorageBuffer sprites_, corners_, tiles_;
    LitRows bufferLit_;  // of castBuffer
    OcclusionRays occlusionRays_;
    SpriteTextures scratch_;
};

}  // namespace voxprite
