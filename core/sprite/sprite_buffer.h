// The sprite itself: one value a virtual pixel, cast by the lattice caster, then outlined.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/model/game_profile.h"
#include "core/model/palette.h"
#include "core/svo/octree.h"
#include "core/trace/lattice.h"

namespace voxprite {

inline constexpr std::uint32_t kIdEmpty = 0;
inline constexpr std::uint32_t kIdOutline = 1;
inline constexpr std::uint32_t kIdFirstVoxel = 2;  // + x + y * size.x + z * size.x * size.y

// Rows from the top: row r holds j = first.y + size.y - 1 - r; column c holds i = first.x + c.
struct SpriteBuffer {
    glm::ivec2 first{0};
    glm::ivec2 size{0};
    std::vector<Rgba8> colours;      // empty 0,0,0,0; outline its RGB, 255; hit: lit colour, 255
    std::vector<std::uint32_t> ids;  // kIdEmpty, kIdOutline or kIdFirstVoxel + index (mod 2^32)

    [[nodiscard]] std::string sha256() const;         // of the RGBA8 rows
    [[nodiscard]] std::string idsSha256() const;      // of the R32UI rows, little-endian
    [[nodiscard]] std::uint64_t opaqueCount() const;  // hits
    [[nodiscard]] std::uint64_t outlineCount() const;
    [[nodiscard]] Image image() const;
};

// The palette with the light in it. Parallel rays see at most one face an axis, so three light
// values make a sprite: a channel becomes (channel * light8[axis] + 127) / 255, in integers.
struct LitPalette {
    std::array<Rgba8, 256> colours{};
    std::array<std::uint8_t, 3> light8{255, 255, 255};
    Outline outline;

    bool operator==(const LitPalette&) const = default;
    [[nodiscard]] Rgba8 shade(std::uint8_t material, std::uint8_t faceAxis) const;
};

[[nodiscard]] LitPalette litPalette(const Palette& palette, std::array<std::uint8_t, 3> light8,
                                    const Outline& outline);

// light8 of the faces that rays along `direction` (voxel space) can see; `towardLight` in voxel
// space too, any length: round(255 * (ambient + (1 - ambient) * max(0, n . l))).
[[nodiscard]] std::array<std::uint8_t, 3> faceLight(glm::ivec3 direction, glm::dvec3 towardLight,
                                                    double ambient);

// threads <= 0: all cores.
[[nodiscard]] SpriteBuffer castSprite(const OctreeView& octree, const LatticeView& lattice,
                                      const LitPalette& lit, int threads = 0);

// Adds the outline: an empty pixel with an opaque cardinal neighbour. Part of castSprite.
void dilateOutline(SpriteBuffer& buffer, Rgba8 colour);

}  // namespace voxprite
