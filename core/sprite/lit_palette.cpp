#include "core/sprite/lit_palette.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace voxprite {

LitPalette litPalette(PaletteShader& shader, std::array<std::uint8_t, 3> light8,
                      const Outline& outline, Shading shading) {
    LitPalette lit;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lit.faces[axis] = shader.inLight(light8[axis], shading);
    }
    lit.outline = outline;
    return lit;
}

LitPalette litPalette(const Palette& palette, std::array<std::uint8_t, 3> light8,
                      const Outline& outline, Shading shading) {
    PaletteShader shader(palette);
    return litPalette(shader, light8, outline, shading);
}

std::array<std::uint8_t, 3> faceLight(glm::ivec3 direction, glm::dvec3 towardLight,
                                      double ambient) {
    // Scaled first: the square of a huge or tiny length has no double.
    const double largest =
        std::max({std::abs(towardLight.x), std::abs(towardLight.y), std::abs(towardLight.z)});
    const glm::dvec3 toward =
        largest > 0.0 ? glm::normalize(towardLight / largest) : glm::dvec3(0.0);
    std::array<std::uint8_t, 3> light8{};
    for (int axis = 0; axis < 3; ++axis) {
        const int normal = direction[axis] > 0 ? -1 : direction[axis] < 0 ? 1 : 0;
        const double light = ambient + (1.0 - ambient) * std::max(0.0, normal * toward[axis]);
        light8[static_cast<std::size_t>(axis)] =
            static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(light, 0.0, 1.0)));
    }
    return light8;
}

}  // namespace voxprite
