// Edits of a whole model (or of what is selected of it): what is kept of it, its place.
#pragma once

#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/edit/patches.h"
#include "core/edit/voxel_set.h"

namespace voxprite {

// Everything outside `keep` goes away.
[[nodiscard]] Result<VoxelPatch> patchCrop(const Document& document, int model,
                                           const VoxelSet& keep);

// Where to move what has these bounds: its middle to the origin in x and y, or its lowest layer to
// z = 0. Odd sizes have their middle voxel at 0.
[[nodiscard]] glm::ivec3 offsetToCentre(const IBox& bounds);
[[nodiscard]] glm::ivec3 offsetToGround(const IBox& bounds);

}  // namespace voxprite
