// The palette with the light in it: a finished table, so that whoever draws only looks up.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/palette_shading.h"

namespace voxprite {

// Parallel rays see at most one face an axis, so three lights make a sprite.
struct LitPalette {
    // faces[axis][index]: the colour of a voxel on the face across that axis; alpha 255.
    std::array<ShadedColours, 3> faces = allFaces(Rgba8(0, 0, 0, 255));
    Outline outline;

    bool operator==(const LitPalette&) const = default;
    [[nodiscard]] Rgba8 shade(std::uint8_t material, std::uint8_t faceAxis) const {
        return faces[faceAxis][material];
    }
    [[nodiscard]] static std::array<ShadedColours, 3> allFaces(Rgba8 colour) {
        std::array<ShadedColours, 3> faces{};
        for (ShadedColours& face : faces) face.fill(colour);
        return faces;
    }
};

// `light8` are the lights of the three faces, see faceLight.
[[nodiscard]] LitPalette litPalette(const Palette& palette, std::array<std::uint8_t, 3> light8,
                                    const Outline& outline, Shading shading = Shading::multiply);
[[nodiscard]] LitPalette litPalette(PaletteShader& shader, std::array<std::uint8_t, 3> light8,
                                    const Outline& outline, Shading shading);

// light8 of the faces that rays along `direction` (voxel space) can see; `towardLight` in voxel
// space too, any length: round(255 * (ambient + (1 - ambient) * max(0, n . l))).
[[nodiscard]] std::array<std::uint8_t, 3> faceLight(glm::ivec3 direction, glm::dvec3 towardLight,
                                                    double ambient);

}  // namespace voxprite
