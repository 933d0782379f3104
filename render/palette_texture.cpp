#include "render/palette_texture.h"

#include <glad/gl.h>

namespace voxprite {

void PaletteTexture::set(std::vector<Rgba8> rows) {
    if (rows == pixels_) return;
    const auto height = static_cast<GLsizei>(rows.size() / 256);
    if (rows.size() != pixels_.size()) {
        texture_ = gl::createTexture2d();
        glTextureStorage2D(texture_.id(), 1, GL_RGBA8, 256, height);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glTextureSubImage2D(texture_.id(), 0, 0, 0, 256, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        rows.data());
    pixels_ = std::move(rows);
}

void bindTexture(TextureUnit unit, std::uint32_t texture) {
    glBindTextureUnit(static_cast<GLuint>(unit), texture);
    // A sampler object left by somebody else would filter integers.
    glBindSampler(static_cast<GLuint>(unit), 0);
}

void bindImage(ImageUnit unit, std::uint32_t textureArray) {
    glBindImageTexture(static_cast<GLuint>(unit), textureArray, 0, GL_TRUE, 0, GL_READ_ONLY,
                       GL_R32UI);
}

}  // namespace voxprite
