// Patches for the basic edits. Tools turn input into one of these; they never touch a grid.
#pragma once

#include <cstdint>
#include <span>

#include "core/edit/history.h"

namespace voxprite {

enum class EditMode : std::uint8_t {
    attach,  // empty voxels become `value`
    erase,   // solid voxels become empty
    paint    // solid voxels become `value`
};

// Only voxels that change are in the patch. `positions` may name a voxel twice.
[[nodiscard]] VoxelPatch patchVoxels(const Document& document, int model,
                                     std::span<const glm::ivec3> positions, EditMode mode,
                                     std::uint8_t value);
// Both corners included (IBox::around). Erase and paint cost what is solid, not the box.
[[nodiscard]] VoxelPatch patchBox(const Document& document, int model, const IBox& box,
                                  EditMode mode, std::uint8_t value);

}  // namespace voxprite
