#include "render/palette_texture.h"

#include <glad/gl.h>

namespace voxprite {

void PaletteTexture::set(std::span<const Rgba8, 256> colours) {
    upload({colours.begin(), colours.end()});
}

void PaletteTexture::set(const LitPalette& lit) {
    std::vector<Rgba8> pixels;
    pixels.reserve(3 * 256);
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        for (int material = 0; material < 256; ++material) {
            pixels.push_back(lit.shade(static_cast<std::uint8_t>(material), axis));
        }
    }
    upload(std::move(pixels));
}

void PaletteTexture::upload(std::vector<Rgba8> pixels) {
    if (pixels == pixels_) return;
    const auto rows = static_cast<GLsizei>(pixels.size() / 256);
    if (pixels.size() != pixels_.size()) {
        texture_ = gl::createTexture2d();
        glTextureStorage2D(texture_.id(), 1, GL_RGBA8, 256, rows);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glTextureSubImage2D(texture_.id(), 0, 0, 0, 256, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.data());
    pixels_ = std::move(pixels);
}

void bindTexture(TextureUnit unit, std::uint32_t texture) {
    glBindTextureUnit(static_cast<GLuint>(unit), texture);
    // A sampler object left by somebody else would filter integers.
    glBindSampler(static_cast<GLuint>(unit), 0);
}

}  // namespace voxprite
