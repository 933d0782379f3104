// A coarser octree (core/svo/coarsen.h) in the place of the fine one.
#pragma once

#include "core/sprite/placed_entity.h"

namespace voxprite {

// Where coarsen(octree, origin, levels) stands so that every voxel lies inside its cell, exactly:
// an entity of 2^levels times the scale, whose virtual pixels are as wide in the world as before
// (while sigma times that scale is in range; beyond, sigma is halved) and whose anchor, centre,
// plane and depth are those of `fine`. `fine` has the size of the fine octree; `origin` is where
// its voxel (0,0,0) lies in entity space.
[[nodiscard]] PlacedEntity coarseEntity(const PlacedEntity& fine, glm::ivec3 origin, int levels);

}  // namespace voxprite
