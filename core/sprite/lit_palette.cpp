#include "core/sprite/lit_palette.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace voxprite {

namespace {

std::uint8_t byteOf(double light) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(light, 0.0, 1.0)));
}

int statesOf(const FaceRays& rays) {
    if (rays.shadows()) return 2 * kOcclusionLevels;
    return rays.occlusion ? kOcclusionLevels : 1;
}

}  // namespace

std::uint8_t FaceLights::of(int faceAxis, FaceShade shade) const {
    constexpr int kWhole = 255 * kOcclusionLevels;
    const int light = (shade.shadowed ? shadowed : open)[static_cast<std::size_t>(faceAxis)];
    const int left = kWhole - occlusion * shade.occlusion;
    return static_cast<std::uint8_t>((light * left + kWhole / 2) / kWhole);
}

bool hasOcclusion(const Light& light) {
    return byteOf(light.occlusion) > 0;
}

bool hasShadows(const Light& light) {
    return light.shadow > 0.0;
}

FaceLights faceLights(glm::ivec3 direction, const glm::dmat3& voxelFromWorldAxes,
                      const Light& light) {
    const glm::dvec3 towardLight = voxelFromWorldAxes * light.towardLight;
    FaceLights lights(faceLight(direction, towardLight, light.ambient));
    lights.occlusion = byteOf(light.occlusion);
    lights.rays.occlusion = hasOcclusion(light);
    if (!hasShadows(light)) return lights;
    lights.rays.towardLight = shadowDirection(towardLight);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double open = lights.open[axis];
        const double direct = std::max(0.0, open - 255.0 * light.ambient);
        lights.shadowed[axis] = byteOf((open - light.shadow * direct) / 255.0);
    }
    return lights;
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
        light8[static_cast<std::size_t>(axis)] =
            byteOf(ambient + (1.0 - ambient) * std::max(0.0, normal * toward[axis]));
    }
    return light8;
}

LitPalette litPalette(PaletteShader& shader, const FaceLights& lights, const Outline& outline,
                      Shading shading) {
    LitPalette lit;
    lit.outline = outline;
    lit.rays = lights.rays;
    const int states = statesOf(lights.rays);
    lit.faces.clear();
    lit.faces.reserve(static_cast<std::size_t>(3 * states));
    for (int state = 0; state < states; ++state) {
        const FaceShade shade{state % kOcclusionLevels, state >= kOcclusionLevels};
        for (int axis = 0; axis < 3; ++axis) {
            lit.faces.push_back(shader.inLight(lights.of(axis, shade), shading));
        }
    }
    return lit;
}

LitPalette litPalette(const Palette& palette, const FaceLights& lights, const Outline& outline,
                      Shading shading) {
    PaletteShader shader(palette);
    return litPalette(shader, lights, outline, shading);
}

}  // namespace voxprite
