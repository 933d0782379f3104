// The exact scalar caster: the specification that every faster caster and the shaders must equal.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/svo/octree.h"
#include "core/trace/lattice.h"
#include "core/trace/octree_walk.h"

namespace voxprite {

// An infinite line of the lattice. `origin` in lattice units (2^positionBits a voxel) from the
// model's minimum corner, |direction| <= 2^directionBits; (0,0,0) hits nothing.
struct LatticeRay {
    glm::i64vec3 origin{0};
    glm::ivec3 direction{0, 1, 0};
    int positionBits = 8;
};

[[nodiscard]] LatticeRay rayOf(const LatticeView& lattice, glm::ivec2 pixel);

// The first solid cell along the whole line.
[[nodiscard]] LatticeHit castLattice(const OctreeView& octree, const LatticeRay& ray);

// castLattice(octree, rayOf(lattice, pixel)) for many pixels: what parallel rays share is worked
// out once. One instance may serve many threads; it must not outlive the octree's arrays.
class LatticeCaster {
  public:
    // `lattice` as quantiseView or validateLattice leave it.
    LatticeCaster(const OctreeView& octree, const LatticeView& lattice);
    [[nodiscard]] LatticeHit cast(glm::ivec2 pixel) const;

  private:
    LatticeView lattice_;  // its C from the root's minimum corner
    Course course_;
};

}  // namespace voxprite
