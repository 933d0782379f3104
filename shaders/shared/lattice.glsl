// The integer lattice caster: the twin of core/trace/lattice_caster, bit for bit.

#include "shared/lattice_point.glsl"
#include "shared/ray_varyings.glsl"
#include "shared/octree.glsl"
#include "shared/lattice_walk.glsl"

struct LatticeHit {
    uint material;  // 0: nothing was hit
    int face_axis;
    ivec3 voxel;
};

LatticeHit castLattice(ivec2 pixel) {
    int edge = 1 << int(svo_max_depth);
    ivec3 size = ivec3(svo_model_size);
    mirrorLines(lattice_direction, clamp(tree_from_voxel, 0, edge),
                clamp(tree_from_voxel + size, 0, edge), tree_from_voxel + size / 2);
    Number3 origin = Number3(mirror_sign) *
                     latticePoint(lattice_origin, lattice_right, lattice_up, pixel);
    Cursor cursor;
    startAtRoot(cursor);
    Meeting met = walkLine(latest(box_low, origin), origin, cursor);
    return LatticeHit(met.material, met.axis, met.cell - tree_from_voxel);
}

uint voxelId(LatticeHit hit) {
    uvec3 v = uvec3(hit.voxel);
    uint id = 2u + v.x + svo_model_size.x * (v.y + svo_model_size.y * v.z);
    return id < 2u ? id + 2u : id;
}
