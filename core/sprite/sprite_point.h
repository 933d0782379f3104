// Where a point of the model shows in its sprite: what sockets are placed by.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/svo/octree.h"
#include "core/trace/lattice.h"

namespace voxprite {

struct SpritePoint {
    // From the left and top of the sprite buffer; the middle of its first pixel is (0.5, 0.5). May
    // lie outside: a point need not lie in the model.
    glm::dvec2 px{0.0};
    // No voxel stands between the eye and the point, the one around it aside. (A point on a face is
    // in no voxel.)
    bool visible = false;
};

// `point` in voxels from the model's minimum corner; the lattice must not be empty.
[[nodiscard]] SpritePoint locateInSprite(const LatticeView& lattice, const OctreeView& octree,
                                         glm::dvec3 point);

}  // namespace voxprite
