#include "render/picture_texture.h"

#include <glad/gl.h>

namespace voxprite {

void PictureTexture::set(const Image& image) {
    if (image.width != width_ || image.height != height_) {
        texture_.reset();
        width_ = image.width;
        height_ = image.height;
        if (image.pixels.empty()) return;
        texture_ = gl::createTexture2d();
        glTextureStorage2D(texture_.id(), 1, GL_RGBA8, width_, height_);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    if (image.pixels.empty()) return;
    glTextureSubImage2D(texture_.id(), 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
}

}  // namespace voxprite
