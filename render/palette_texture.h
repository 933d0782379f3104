// Palette colours as a texture: column = material, a row for each kind of face, with its light.
#pragma once

#include <vector>

#include "core/base/image.h"
#include "render/gl/handles.h"
#include "render/gpu_blocks.h"

namespace voxprite {

// Uploads only what differs from what it holds.
class PaletteTexture {
  public:
    void set(std::vector<Rgba8> rows);  // 256 colours each
    [[nodiscard]] std::uint32_t texture() const { return texture_.id(); }

  private:
    gl::Texture texture_;
    std::vector<Rgba8> pixels_;
};

void bindTexture(TextureUnit unit, std::uint32_t texture);
// A texture array of R32UI, to be read texel by texel.
void bindImage(ImageUnit unit, std::uint32_t textureArray);

}  // namespace voxprite
