// The programs that draw sprites, and the draw itself.
#pragma once

#include <array>
#include <string>

#include "core/base/result.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/sprite_blocks.h"

namespace voxprite {

// What a program is compiled with, as a sum.
using SpriteVariants = unsigned;
inline constexpr SpriteVariants kPlain = 0;
inline constexpr SpriteVariants kWideLattice = 1;    // rays beyond 31 bits; right for all, but slow
inline constexpr SpriteVariants kPerPixelDepth = 2;  // a depth for each pixel
inline constexpr SpriteVariants kProxyBox = 4;       // the region is the proxy box, not the quad
inline constexpr SpriteVariants kSpriteIds = 8;      // ids of voxels are kept beside the colours
inline constexpr SpriteVariants kFaceShade = 16;     // faces cast rays: occlusion, shadows

// A program in all variants, each compiled when first used: of two stages, or a compute shader.
class SpriteProgram {
  public:
    explicit SpriteProgram(std::string compute) : compute_(std::move(compute)) {}
    SpriteProgram(std::string vertex, std::string fragment)
        : vertex_(std::move(vertex)), fragment_(std::move(fragment)) {}
    [[nodiscard]] Status use(SpriteVariants variants);

  private:
    std::string vertex_, fragment_, compute_;
    std::array<gl::Program, 32> programs_;
};

// The vertices of any number of sprites.
class SpriteShapes {
  public:
    SpriteShapes();
    // One draw of the program and the buffers that are bound, into the framebuffer that is bound.
    void draw(const SpriteDrawBlock& block, bool boxes = false);

  private:
    struct Shape {
        gl::Buffer indices;
        gl::VertexArray vertices;
    };
    Shape quads_, boxes_;
    gl::UniformBuffer drawBlock_;
};

}  // namespace voxprite
