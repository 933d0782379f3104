// Edits of a whole model (or of what is selected of it): colours, shells, growth, place.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/edit/patches.h"
#include "core/edit/voxel_set.h"

namespace voxprite {

// The patch that makes the model's voxels those of `after`, within the limits. Blocks that do not
// differ cost nothing but a comparison. Fails beyond kMaxPatchVoxels.
[[nodiscard]] Result<VoxelPatch> patchReplace(const Document& document, int model,
                                              const VoxelGrid& after,
                                              const EditLimits& limits = {});

// Voxels of the colour `from` become `to` (0 deletes them).
[[nodiscard]] Result<VoxelPatch> patchRecolour(const Document& document, int model,
                                               std::uint8_t from, std::uint8_t to,
                                               const EditLimits& limits = {});
// Everything outside `keep` goes away.
[[nodiscard]] Result<VoxelPatch> patchCrop(const Document& document, int model,
                                           const VoxelSet& keep);

// What core/model/voxel_morphology.h does, as patches.
[[nodiscard]] Result<VoxelPatch> patchHollow(const Document& document, int model, int wall,
                                             const EditLimits& limits = {});
[[nodiscard]] Result<VoxelPatch> patchDilate(const Document& document, int model, int layers,
                                             const EditLimits& limits = {});
[[nodiscard]] Result<VoxelPatch> patchErode(const Document& document, int model, int layers,
                                            const EditLimits& limits = {});
[[nodiscard]] Result<VoxelPatch> patchSmooth(const Document& document, int model, int passes,
                                             const EditLimits& limits = {});

// All voxels of the model, moved. (Shared by several objects, it moves in all of them; to move one
// object, change its placement instead.)
[[nodiscard]] Result<VoxelPatch> patchTranslate(const Document& document, int model,
                                                glm::ivec3 byVoxels);
// Where to move what has these bounds: its middle to the origin in x and y, or its lowest layer to
// z = 0. Odd sizes have their middle voxel at 0.
[[nodiscard]] glm::ivec3 offsetToCentre(const IBox& bounds);
[[nodiscard]] glm::ivec3 offsetToGround(const IBox& bounds);

}  // namespace voxprite
