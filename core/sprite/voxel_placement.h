// An entity's place, as rays into its voxels need it.
#pragma once

#include "core/sprite/placed_entity.h"
#include "core/trace/raycast.h"

namespace voxprite {

[[nodiscard]] inline VoxelPlacement voxelPlacement(const PlacedEntity& placed) {
    return {placed.worldFromVoxelAxes, placed.anchor, placed.anchorMetres, placed.metresPerVoxel()};
}

}  // namespace voxprite
