// 256 colours shared by all models of a document. Index 0 is empty and stays transparent black.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "core/base/image.h"

namespace voxprite {

// Material properties as their file names them ("_type" -> "_glass", "_rough" -> "0.1", ...).
// voxprite keeps them for the game; the sprite does not use them.
using Properties = std::map<std::string, std::string>;

struct Palette {
    std::array<Rgba8, 256> colours{};
    std::array<std::string, 256> names;
    std::array<Properties, 256> materials;
    // displayOrder[slot] is the palette index shown in that slot of the palette panel; slot 0 holds
    // index 0. A permutation of 0..255: it orders the display and never the voxels' indices.
    std::array<std::uint8_t, 256> displayOrder = identityOrder();

    bool operator==(const Palette&) const = default;

    [[nodiscard]] static std::array<std::uint8_t, 256> identityOrder();
    // The palette a .vox file without RGBA chunk means (MagicaVoxel's default 255 colours).
    [[nodiscard]] static Palette standard();
};

}  // namespace voxprite
