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

namespace {

// The walk counts from the root's minimum corner.
LatticeHit castFrom(const Course& course, glm::i64vec3 origin) {
    const glm::i64vec3 treeFromVoxel(course.octree.treeFromVoxel);
    const Line line(course, origin + treeFromVoxel * (std::int64_t{1} << course.positionBits));
    return walk(course, line, line.enter);
}

}  // namespace

LatticeHit castLattice(const OctreeView& octree, const LatticeRay& ray) {
    return castFrom(Course(octree, ray.direction, ray.positionBits), ray.origin);
}

LatticeCaster::LatticeCaster(const OctreeView& octree, const LatticeView& lattice)
    : lattice_(lattice), course_(octree, lattice.D, lattice.positionBits) {}

LatticeHit LatticeCaster::cast(glm::ivec2 pixel) const {
    return castFrom(course_, rayOf(lattice_, pixel).origin);
}

}  // namespace voxprite
