// The palette with the light in it: a finished table, so that whoever draws only looks up.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/sprite/face_shade.h"
#include "core/sprite/palette_shading.h"

namespace voxprite {

// The lights, 0 ... 255, of all that parallel rays can see: at most one face an axis, and each of
// those with what is around it.
struct FaceLights {
    std::array<std::uint8_t, 3> open{255, 255, 255};      // by axis, with nothing around
    std::array<std::uint8_t, 3> shadowed{255, 255, 255};  // the same in shadow
    std::uint8_t occlusion = 0;                           // its strength, 0 ... 255
    FaceRays rays;                                        // what they shall look for

    FaceLights() = default;
    // Without occlusion and shadow.
    FaceLights(std::array<std::uint8_t, 3> light8) : open(light8), shadowed(light8) {}
    FaceLights(std::uint8_t x, std::uint8_t y, std::uint8_t z) : FaceLights(std::array{x, y, z}) {}

    bool operator==(const FaceLights&) const = default;
    // Occlusion of level l takes l / kOcclusionLevels of it, times its strength; rounded.
    [[nodiscard]] std::uint8_t of(int faceAxis, FaceShade shade) const;
};

// The lights of the faces that rays along `direction` (voxel space) can see; `voxelFromWorldAxes`
// turns light.towardLight into voxel space. Shadow takes its share of what is not ambient.
[[nodiscard]] FaceLights faceLights(glm::ivec3 direction, const glm::dmat3& voxelFromWorldAxes,
                                    const Light& light);

// Does a sprite in this light cast rays from its faces?
[[nodiscard]] bool hasOcclusion(const Light& light);
[[nodiscard]] bool hasShadows(const Light& light);

// light8 of the faces that rays along `direction` (voxel space) can see; `towardLight` in voxel
// space too, any length: round(255 * (ambient + (1 - ambient) * max(0, n . l))).
[[nodiscard]] std::array<std::uint8_t, 3> faceLight(glm::ivec3 direction, glm::dvec3 towardLight,
                                                    double ambient);

struct LitPalette {
    // faces[rowOf(axis, shade)][index]: the colour of a voxel on a face; alpha 255. As many rows as
    // the rays can tell apart: three, with occlusion 3 * kOcclusionLevels, with shadows twice that.
    std::vector<ShadedColours> faces = allFaces(Rgba8(0, 0, 0, 255));
    Outline outline;
    FaceRays rays;  // what a face is asked for before it is looked up

    bool operator==(const LitPalette&) const = default;
    [[nodiscard]] static std::size_t rowOf(int faceAxis, FaceShade shade) {
        const int state = shade.occlusion + (shade.shadowed ? kOcclusionLevels : 0);
        return static_cast<std::size_t>(faceAxis + 3 * state);
    }
    [[nodiscard]] Rgba8 shade(std::uint8_t material, std::uint8_t faceAxis,
                              FaceShade shade = {}) const {
        return faces[rowOf(faceAxis, shade)][material];
    }
    [[nodiscard]] static std::vector<ShadedColours> allFaces(Rgba8 colour) {
        ShadedColours face;
        face.fill(colour);
        return {3, face};
    }
};

[[nodiscard]] LitPalette litPalette(const Palette& palette, const FaceLights& lights,
                                    const Outline& outline, Shading shading = Shading::multiply);
[[nodiscard]] LitPalette litPalette(PaletteShader& shader, const FaceLights& lights,
                                    const Outline& outline, Shading shading);

}  // namespace voxprite
