// Palette colours as a texture: column = material, one row, or one for each face axis with the
// light in it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/image.h"
#include "core/sprite/sprite_buffer.h"
#include "render/gl/handles.h"
#include "render/gpu_blocks.h"

namespace voxprite {

// Uploads only what differs from what it holds.
class PaletteTexture {
  public:
    void set(std::span<const Rgba8, 256> colours);
    void set(const LitPalette& lit);
    [[nodiscard]] std::uint32_t texture() const { return texture_.id(); }

  private:
    void upload(std::vector<Rgba8> pixels);

    gl::Texture texture_;
    std::vector<Rgba8> pixels_;
};

void bindTexture(TextureUnit unit, std::uint32_t texture);

}  // namespace voxprite
