// The exact scalar caster: the specification that every faster caster and the shaders must equal.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/svo/octree.h"
#include "core/trace/lattice.h"

namespace voxprite {

struct LatticeHit {
    std::uint8_t material = 0;  // 0: nothing was hit
    // The axis whose face the ray came through (0 x, 1 y, 2 z). The face's outward normal points
    // against D on that axis.
    std::uint8_t faceAxis = 0;
    glm::ivec3 voxel{0};
};

// An infinite line of the lattice. `origin` in lattice units (2^positionBits a voxel) from the
// model's minimum corner, |direction| <= 2^directionBits, not all zero.
struct LatticeRay {
    glm::i64vec3 origin{0};
    glm::ivec3 direction{0, 1, 0};
    int positionBits = 8;
};

[[nodiscard]] LatticeRay rayOf(const LatticeView& lattice, glm::ivec2 pixel);

// The first solid cell along the whole line.
[[nodiscard]] LatticeHit castLattice(const OctreeView& octree, const LatticeRay& ray);

// For perspective rays (voxel views, picking): the same walk along a line quantised near where the
// ray enters the box. `eye` in voxel units from the minimum corner, `direction` of any length; only
// what lies ahead of the eye counts; `t` is in voxels along the normalised direction. An eye inside
// a solid voxel hits that voxel (t = 0, faceAxis of the largest direction component).
struct PerspectiveHit {
    LatticeHit hit;
    double t = 0.0;
};
[[nodiscard]] PerspectiveHit castPerspective(const OctreeView& octree, glm::dvec3 eye,
                                             glm::dvec3 direction);

}  // namespace voxprite
