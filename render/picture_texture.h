// A picture on the GPU, shown pixel by pixel (no filtering).
#pragma once

#include <cstdint>

#include "core/base/image.h"
#include "render/gl/handles.h"

namespace voxprite {

class PictureTexture {
  public:
    // Needs a current GL 4.5 context. An empty picture leaves nothing to show.
    void set(const Image& image);
    [[nodiscard]] std::uint32_t id() const { return texture_.id(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

  private:
    gl::Texture texture_;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace voxprite
