// Pulling a face out of a model, or pushing it in.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/base/result.h"
#include "core/edit/patches.h"
#include "core/edit/voxel_set.h"

namespace voxprite {

inline constexpr int kMaxFaceLayers = 1024;

// What faceRegion() gave for `normal`. Several are moved at once, as symmetry makes them.
struct MovedFace {
    VoxelSet face;
    glm::ivec3 normal{0, 0, 1};
};
// Positive `layers` put that many layers on each face, each voxel in the colour of its face or, if
// given, in `colour`; voxels in the way stay as they are. Negative ones take that many layers away,
// beginning with the face. Fails beyond kMaxFaceLayers and kMaxPatchVoxels.
[[nodiscard]] Result<VoxelPatch> patchFaces(const Document& document, int model,
                                            std::span<const MovedFace> faces, int layers,
                                            std::optional<std::uint8_t> colour = std::nullopt,
                                            const EditLimits& limits = {});

}  // namespace voxprite
