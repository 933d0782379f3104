// Lists of voxel changes in the form that recorded steps have: ascending positions, none twice.
#pragma once

#include <vector>

#include "core/edit/history.h"

namespace voxprite {

// Sorted; where a position stands several times, the first before and the last after.
[[nodiscard]] std::vector<VoxelChange> uniqueChanges(std::vector<VoxelChange> changes);
// Removes what ends as it began.
void dropUnchanged(std::vector<VoxelChange>& changes);
// What `earlier` and then `later`, both unique, do together; what is back at its start drops out.
[[nodiscard]] std::vector<VoxelChange> mergedChanges(const std::vector<VoxelChange>& earlier,
                                                     const std::vector<VoxelChange>& later);

}  // namespace voxprite
