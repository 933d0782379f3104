// Lists of voxel changes in the form that recorded steps have: ascending positions, none twice.
#pragma once

#include <vector>

#include "core/edit/history.h"

namespace voxprite {

// Sorted; where a position stands several times, the first before and the last after.
[[nodiscard]] std::vector<VoxelChange> uniqueChanges(std::vector<VoxelChange> changes);
// Removes what ends as it began.
void dropUnchanged(std::vector<VoxelChange>& changes);
// Makes of `earlier` what it and then `later` do together, both in that form; what is back at its
// start drops out. In place, since a long stroke merges thousands of small changes into a large
// list.
void mergeChanges(std::vector<VoxelChange>& earlier, const std::vector<VoxelChange>& later);

}  // namespace voxprite
