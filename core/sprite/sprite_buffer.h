// The sprite itself: one value a virtual pixel, cast by the lattice caster, then outlined.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>

#include "core/base/image.h"
#include "core/base/unfilled_vector.h"
#include "core/sprite/lit_palette.h"
#include "core/svo/octree.h"
#include "core/trace/lattice.h"

namespace voxprite {

inline constexpr std::uint32_t kIdEmpty = 0;
inline constexpr std::uint32_t kIdOutline = 1;
inline constexpr std::uint32_t kIdFirstVoxel = 2;  // + x + y * size.x + z * size.x * size.y

[[nodiscard]] std::uint32_t voxelId(glm::ivec3 voxel, glm::ivec3 modelSize);

// Rows from the top: row r holds j = first.y + size.y - 1 - r; column c holds i = first.x + c.
struct SpriteBuffer {
    glm::ivec2 first{0};
    glm::ivec2 size{0};
    UnfilledVector<Rgba8> colours;      // empty 0,0,0,0; outline its RGB, 255; hit: lit colour, 255
    UnfilledVector<std::uint32_t> ids;  // kIdEmpty, kIdOutline or kIdFirstVoxel + index (mod 2^32)

    [[nodiscard]] std::string sha256() const;         // of the RGBA8 rows
    [[nodiscard]] std::string idsSha256() const;      // of the R32UI rows, little-endian
    [[nodiscard]] std::uint64_t opaqueCount() const;  // hits
    [[nodiscard]] std::uint64_t outlineCount() const;
    [[nodiscard]] Image image() const;
};

// threads <= 0: all cores.
[[nodiscard]] SpriteBuffer castSprite(const OctreeView& octree, const LatticeView& lattice,
                                      const LitPalette& lit, int threads = 0);

}  // namespace voxprite
