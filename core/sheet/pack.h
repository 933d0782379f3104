// Rectangles into a picture that is as small as the skyline method finds (stb_rect_pack).
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/base/result.h"

namespace voxprite {

struct Packing {
    std::vector<glm::ivec2> corners;  // left and top of each rectangle
    glm::ivec2 size{0};
};

// With `padding` pixels between rectangles. Fails when no picture within `largestEdge` holds them.
[[nodiscard]] Result<Packing> packRectangles(const std::vector<glm::ivec2>& sizes, int padding,
                                             int largestEdge);

}  // namespace voxprite
