// The voxels of one model as bytes, the way a .voxprite file stores them (before compression).
// Private to core/io.
//
//   0   "VXL1"
//   4   u32      blocks
//   8   blocks   i32 x, y, z   the minimum corner, a multiple of the edge
//                u8  edge      3 ... 9: log2 of the cube's edge in voxels
//                u8  value     1..255: every voxel has it; 0: edge is 3 and 512 values follow,
//                              value [(x << 6) | (y << 3) | z], 0 empty
//
// All little-endian. A voxel that no block holds is empty; blocks do not overlap.
#pragma once

#include "core/base/bytes.h"
#include "core/io/grid_budget.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

[[nodiscard]] Result<Bytes> writeVoxelPayload(const VoxelGrid& voxels);
// Memory is bounded by the payload's own length times a small constant and by `budget`, out of
// which blocks of one value are paid.
[[nodiscard]] Result<VoxelGrid> readVoxelPayload(ByteView bytes, GridBudget& budget);

}  // namespace voxprite
