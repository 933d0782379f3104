// Boxes of an octree at once: what clusters are cut from.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/box.h"
#include "core/svo/octree.h"

namespace voxprite {

// The materials of a box in tree space, x fastest, then y; 0 outside the model. `out` has one byte
// a voxel of the box.
void readBox(const OctreeView& octree, const IBox& box, std::span<std::uint8_t> out);

// Whether every voxel of a box in tree space is solid; none outside the model is.
[[nodiscard]] bool solidThroughout(const OctreeView& octree, const IBox& box);

}  // namespace voxprite
