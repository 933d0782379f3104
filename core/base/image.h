// An 8-bit RGBA picture in memory: straight (not premultiplied) alpha, top row first.
#pragma once

#include <cstddef>
#include <glm/ext/vector_uint4_sized.hpp>
#include <vector>

namespace voxprite {

using Rgba8 = glm::u8vec4;

struct Image {
    int width = 0;
    int height = 0;
    std::vector<Rgba8> pixels;  // width * height, row by row from the top

    Image() = default;
    Image(int widthPx, int heightPx, Rgba8 fill = Rgba8(0))
        : width(widthPx),
          height(heightPx),
          pixels(static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx), fill) {}

    [[nodiscard]] Rgba8& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    [[nodiscard]] const Rgba8& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    bool operator==(const Image&) const = default;
};

}  // namespace voxprite
