// Voxels lifted out of a model: the clipboard, a stamp, a selection on the move. Moving, turning
// and flipping a clip changes its placement alone, so any number of turns loses nothing.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/edit/patches.h"
#include "core/edit/voxel_set.h"
#include "core/model/placement.h"

namespace voxprite {

struct VoxelClip {
    VoxelGrid voxels;  // clip space: where they were copied from
    Placement modelFromClip;
    bool operator==(const VoxelClip&) const = default;

    // In the model they are to go to. O(blocks).
    [[nodiscard]] IBox bounds() const { return modelFromClip.applyToBox(voxels.bounds()); }
    // With the placement carried out: model space. What lies beyond the range is left out.
    [[nodiscard]] VoxelGrid placed() const;
    [[nodiscard]] VoxelSet footprint() const;
};

// The selected voxels that are solid.
[[nodiscard]] VoxelClip copyVoxels(const VoxelGrid& voxels, const VoxelSet& selection);

enum class PasteRule : std::uint8_t {
    over,  // the clip's voxels replace what is there
    under  // they only fill what is empty
};
// Nothing outside the limits changes; the rest of the clip is pasted. Fails when the clip reaches
// beyond the range of coordinates, or beyond kMaxPatchVoxels.
[[nodiscard]] Result<VoxelPatch> patchPaste(const Document& document, int model,
                                            const VoxelClip& clip, PasteRule rule = PasteRule::over,
                                            const EditLimits& limits = {});
// Cut and paste in one: the voxels of `from` go away, then the clip (a copy of them that was moved,
// turned or scaled) is laid over what remains. One patch, so nothing is lost until it is executed.
[[nodiscard]] Result<VoxelPatch> patchMove(const Document& document, int model,
                                           const VoxelSet& from, const VoxelClip& clip,
                                           PasteRule rule = PasteRule::over,
                                           const EditLimits& limits = {});

}  // namespace voxprite
