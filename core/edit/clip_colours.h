// Voxels that were copied under one palette, pasted under another: their indices mean other colours
// there, so each colour looks for its own place.
#pragma once

#include <array>
#include <cstdint>

#include "core/model/document.h"

namespace voxprite {

struct ColourMatch {
    // The index of each colour of the source in `palette`; what no voxel uses stays.
    std::array<std::uint8_t, 256> indexOf{};
    Palette palette;       // the document's, with what was added
    int added = 0;         // colours that it lacked
    int approximated = 0;  // for which there was no room

    [[nodiscard]] bool isIdentity() const;
};
// For each colour that `voxels` use, in this order: its own index, if the document has the same
// colour there; the first index that has it, one of the same name before others; a free one
// (freeIndex() of palette_edits.h), which gets colour, name and material; and once there is none,
// that of the nearest colour (OKLab).
[[nodiscard]] ColourMatch matchColours(const VoxelGrid& voxels, const Palette& source,
                                       const Document& document);
[[nodiscard]] VoxelGrid recoloured(const VoxelGrid& voxels,
                                   const std::array<std::uint8_t, 256>& indexOf);

}  // namespace voxprite
