// Sprite buffers on the GPU: one ray a virtual pixel, then the outline by dilation.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sprite/sprite_buffer.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/gpu_octree.h"
#include "render/palette_texture.h"
#include "render/scene_renderer.h"

namespace voxprite {

// A sprite buffer in two textures (bottom row first), which may be larger than the sprite.
struct SpriteTextures {
    gl::Texture colours;  // RGBA8
    gl::Texture ids;      // R32UI
    gl::Framebuffer framebuffer;
    glm::ivec2 capacity{0};

    SpriteTextures() = default;
    explicit SpriteTextures(glm::ivec2 size);
    [[nodiscard]] bool holds(glm::ivec2 size) const {
        return size.x <= capacity.x && size.y <= capacity.y;
    }
};

// The program for 31-bit integers, and the one for larger lattices, compiled when first needed.
class LatticePrograms {
  public:
    LatticePrograms(std::string vertex, std::string fragment, std::vector<std::string> defines = {})
        : vertex_(std::move(vertex)),
          fragment_(std::move(fragment)),
          defines_(std::move(defines)) {}
    [[nodiscard]] Status use(bool narrow);

  private:
    std::string vertex_, fragment_;
    std::vector<std::string> defines_;
    gl::Program narrow_, wide_;
};

class SpriteCaster {
  public:
    [[nodiscard]] static Result<SpriteCaster> create();

    // A buffer of this size as one texture each: fails beyond the driver's limit.
    [[nodiscard]] static Status checkSize(glm::ivec2 size);
    // Puts the finished sprite into `framebuffer` (RGBA8 and R32UI), its lower left at `corner`.
    [[nodiscard]] Status cast(const GpuOctree& octree, const LatticeView& lattice,
                              const LitPalette& lit, std::uint32_t framebuffer,
                              glm::ivec2 corner = glm::ivec2(0));

    // The whole buffer read back, by either mode.
    [[nodiscard]] Result<SpriteBuffer> castBuffer(const GpuOctree& octree,
                                                  const LatticeView& lattice, const LitPalette& lit,
                                                  SpriteMode mode);

    // Binds what the lattice shaders read, palette included.
    void bindInputs(const GpuOctree& octree, const LatticeView& lattice, const LitPalette& lit);

  private:
    [[nodiscard]] Status castSinglePass(const GpuOctree& octree, const LatticeView& lattice,
                                        const LitPalette& lit, SpriteTextures& target);

    LatticePrograms cast_{"fullscreen.vert", "sprite_cast.frag"};
    LatticePrograms single_{"sprite_quad.vert", "sprite_single.frag"};
    gl::Program outline_;
    gl::VertexArray nothing_ = gl::createVertexArray();
    gl::UniformBuffer octreeBlock_, latticeBlock_;
    gl::StorageBuffer sprite_;
    PaletteTexture palette_;
    SpriteTextures scratch_;
};

}  // namespace voxprite
