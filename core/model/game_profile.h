// What all models of a game share: the two numbers, the light, the outline, and which of the
// documented choices the game's renderer makes. One JSON file (core/io/profile_json.h), loaded and
// saved apart from the models. The sections named are those of the sprite specification.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite {

// Which way the parallel rays of a sprite run.
enum class ViewRule : std::uint8_t { cameraForward, towardEntity };
// What the sprite's grid is registered to on screen.
enum class Registration : std::uint8_t { modelCentre, anchor };
// The region that is rasterised: the sprite plane's own rectangle, or the seed's box.
enum class ProxyShape : std::uint8_t { quad, box };
// The depth a sprite writes.
enum class DepthRule : std::uint8_t { centre, groundSafe, perPixel };
// What light does to a colour: multiplies it, or picks another of the palette's, so that a sprite
// has only the artist's colours (core/sprite/palette_shading.h).
enum class Shading : std::uint8_t { multiply, palette };

// How sprites are drawn. Both ways give the same pixels.
enum class SpriteMode : std::uint8_t {
    spriteBuffer,  // one ray a virtual pixel into a small buffer, outline by dilation, nearest blit
    singlePass     // every fragment casts its ray, and up to four neighbours on a miss
};

struct Outline {
    bool enabled = true;
    Rgba8 colour{0, 0, 0, 255};  // alpha is always 255
    bool operator==(const Outline&) const = default;
};

struct Light {
    double ambient = 0.55;  // 0 ... 1: the light of a face turned away
    // Toward the light, in the Y-up world; any length but zero.
    glm::dvec3 towardLight{0.35, 0.8, 0.55};
    // What a sprite's faces lose of it, each face as a whole (core/sprite/face_shade.h). 0 ... 1:
    // how dark a face gets that others stand around, and how much of the light from towardLight
    // misses one that lies in shadow. 0: none, and no ray is cast for it.
    double occlusion = 0.0;
    double shadow = 0.0;
    bool operator==(const Light&) const = default;
};

struct GameProfile {
    double voxelSizeMetres = 0.1;  // 1e-6 ... 1e6
    double sigma = 4.0;            // virtual pixels a voxel, 1/64 ... 64
    ViewRule view = ViewRule::towardEntity;
    Registration registration = Registration::modelCentre;
    ProxyShape proxy = ProxyShape::quad;
    DepthRule depth = DepthRule::groundSafe;
    SpriteMode mode = SpriteMode::spriteBuffer;
    double groundClearancePx =
        1.0;                       // virtual pixels that a grounded entity floats above the ground
    bool minification = true;      // halve sigma while a virtual pixel is under a screen pixel
    double viewStepDegrees = 0.0;  // views snap to this step; 0 is off; at most 45
    Outline outline;
    Light light;
    Shading shading = Shading::multiply;
    bool operator==(const GameProfile&) const = default;
};

// One number by itself, under the name that the message shall give it.
[[nodiscard]] Status checkVoxelSize(const std::string& field, double metres);
inline constexpr double kLeastSigma = 1.0 / 64.0;
inline constexpr double kMostSigma = 64.0;
[[nodiscard]] Status checkSigma(const std::string& field, double sigma);
// Finite and in range, with a message that names the field, its value and the range.
[[nodiscard]] Status validate(const GameProfile& profile);

}  // namespace voxprite
