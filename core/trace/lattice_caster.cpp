#include "core/trace/lattice_caster.h"

#include "core/trace/octree_walk.h"

namespace voxprite {

LatticeRay rayOf(const LatticeView& lattice, glm::ivec2 pixel) {
    LatticeRay ray;
    ray.positionBits = lattice.positionBits;
    ray.direction = lattice.D;
    for (int a = 0; a < 3; ++a) {
        const std::int64_t step =
            std::int64_t{pixel.x} * lattice.U[a] + std::int64_t{pixel.y} * lattice.V[a];
        ray.origin[a] = lattice.C[a] + (step >> kStepShift);
    }
    return ray;
}

LatticeHit castLattice(const OctreeView& octree, const LatticeRay& ray) {
    const Course course(octree, ray.direction, ray.positionBits);
    const glm::i64vec3 treeFromVoxel(octree.treeFromVoxel);
    const Line line(course, ray.origin + treeFromVoxel * (std::int64_t{1} << ray.positionBits));
    return walk(course, line, line.enter);
}

LatticeCaster::LatticeCaster(const OctreeView& octree, const LatticeView& lattice)
    : lattice_(lattice), course_(octree, lattice.D, lattice.positionBits) {
    // The walk counts from the root's minimum corner; so may the rays, from the start.
    lattice_.C += octree.treeFromVoxel * (1 << lattice.positionBits);
}

LatticeHit LatticeCaster::cast(glm::ivec2 pixel) const {
    const Line line(course_, rayOf(lattice_, pixel).origin);
    return walk(course_, line, line.enter);
}

}  // namespace voxprite
