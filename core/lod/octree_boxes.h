// Boxes of an octree at once: what clusters are cut from.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/base/box.h"
#include "core/svo/octree.h"

namespace voxprite {

// The materials of a box in tree space, x fastest, then y; 0 outside the model. `out` has one byte
// a voxel of the box.
void readBox(const OctreeView& octree, const IBox& box, std::span<std::uint8_t> out);

// Visits the empty parts of a box in tree space, each as the box of a node that is empty, cut to
// the box in question. Voxels outside the root cube are not visited.
void forEachEmptyPart(const OctreeView& octree, const IBox& box,
                      const std::function<void(const IBox& part)>& visit);

// Whether every voxel of a box in tree space is solid; none outside the model is.
[[nodiscard]] bool solidThroughout(const OctreeView& octree, const IBox& box);

}  // namespace voxprite
