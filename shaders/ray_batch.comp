// Casts a list of quantised rays: what core's castQuantised finds.

layout(local_size_x = 64) in;

#include "shared/octree_block.glsl"

int leaf_level = 0;
#define LEAF_LEVEL leaf_level

#include "shared/ray_walk.glsl"

struct BatchRay {
    ivec3 origin;
    int leaf_level;
    ivec3 direction;
    int kind;  // 0: misses the box, 1: comes from outside, 2: starts inside
};
struct BatchHit {
    ivec3 voxel;
    uint material_and_axis;  // material | axis << 8; 0: nothing is hit
};

layout(std430, binding = 3) readonly buffer BatchRays { BatchRay rays[]; };
layout(std430, binding = 4) writeonly buffer BatchHits { BatchHit hits[]; };

void main() {
    uint k = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u;
    if (k >= uint(rays.length())) return;
    BatchRay ray = rays[k];
    leaf_level = ray.leaf_level;
    BatchHit hit = BatchHit(ivec3(0), 0u);
    if (ray.kind != 0) {
        ivec3 low, high;
        castableBox(low, high);
        Cursor cursor;
        Meeting met = castQuantised(ray.origin, ray.direction, ray.kind == 2, low, high, cursor);
        if (met.material != 0u) {
            hit.voxel = ((met.cell >> leaf_level) << leaf_level) - tree_from_voxel;
            hit.material_and_axis = met.material | uint(met.axis) << 8u;
        }
    }
    hits[k] = hit;
}
