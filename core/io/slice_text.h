// What voxprite notes in pictures of layers, under the key "voxprite layers": "16 at -3 4 0".
// Private to core/io.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/base/bytes.h"

namespace voxprite {

struct SliceText {
    int layers = 1;
    glm::ivec3 corner{0};  // of the lowest voxel, in entity space
};
[[nodiscard]] std::string textOf(const SliceText& text);
// Nothing where there is none, or none that makes sense.
[[nodiscard]] std::optional<SliceText> sliceTextIn(ByteView png);
inline constexpr const char* kSliceTextKey = "voxprite layers";

}  // namespace voxprite
