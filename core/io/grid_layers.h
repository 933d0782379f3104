// A grid's voxels layer by layer, each layer dense: what formats that list every cell write.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// Boxes of more cells than this are refused; a layer may have 2^26.
inline constexpr std::uint64_t kMaxLayerCells = std::uint64_t{1} << 32;

// Calls visit(coordinate along `axis`, cells) for every layer of `box`, from the lowest. `axis` is
// 1 (y) or 2 (z); cells run along x, then along the other axis, both from the box's low corner; 0
// is empty. What lies outside the box is left out. Eight layers are held at a time. Fails where
// `visit` does, and on a box that is too large.
using VisitLayer = std::function<Status(int coordinate, std::span<const std::uint8_t> cells)>;
[[nodiscard]] Status forEachLayer(const VoxelGrid& grid, const IBox& box, int axis,
                                  const VisitLayer& visit);

}  // namespace voxprite
