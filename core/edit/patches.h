// Patches for the basic edits. Tools turn input into one of these; they never touch a grid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "core/edit/history.h"
#include "core/edit/voxel_set.h"

namespace voxprite {

enum class EditMode : std::uint8_t {
    attach,  // empty voxels become `value`
    erase,   // solid voxels become empty
    paint    // solid voxels become `value`
};

// Where edits may happen: in the artist's bounding box, in the selection. Neither: everywhere.
struct EditLimits {
    std::optional<IBox> box;
    const VoxelSet* only = nullptr;  // not owned
    [[nodiscard]] bool allow(glm::ivec3 v) const {
        return (!box || box->contains(v)) && (only == nullptr || only->contains(v));
    }
};

// More changes than this (of 16 bytes each) in one patch are refused with an error.
inline constexpr std::uint64_t kMaxPatchVoxels = std::uint64_t{1} << 25;

// Only voxels that change are in the patch. `positions` may name a voxel twice.
[[nodiscard]] VoxelPatch patchVoxels(const Document& document, int model,
                                     std::span<const glm::ivec3> positions, EditMode mode,
                                     std::uint8_t value, const EditLimits& limits = {});
// Erase and paint cost what is solid, not the box.
[[nodiscard]] VoxelPatch patchBox(const Document& document, int model, const IBox& box,
                                  EditMode mode, std::uint8_t value);
// Shapes, regions, selections. Costs the blocks of the set and what changes in them. Fails beyond
// kMaxPatchVoxels.
[[nodiscard]] Result<VoxelPatch> patchSet(const Document& document, int model, const VoxelSet& set,
                                          EditMode mode, std::uint8_t value,
                                          const EditLimits& limits = {});

}  // namespace voxprite
