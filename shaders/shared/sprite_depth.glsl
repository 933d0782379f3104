// The depth of a pixel of its own: that of the point where its ray enters the voxel it shows.

#include "shared/lattice_point.glsl"
#include "shared/ray_varyings.glsl"
#include "shared/sprite_draw.glsl"
#include "shared/sprite_varyings.glsl"

// The vertex stage emits the nearest depth of the sprite; a fragment only moves away from it.
layout(depth_less) out float gl_FragDepth;

float pixelDepth(ivec2 cell, ivec3 voxel) {
    // From the centre corner, in lattice steps.
    precise vec3 origin =
        vec3(latticePoint(lattice_origin, lattice_right, lattice_up, cell + region_first));
    precise vec3 direction = vec3(lattice_direction);
    ivec3 far_side = ivec3(lessThan(lattice_direction, ivec3(0)));
    precise vec3 face =
        vec3((voxel - ivec3(svo_model_size / 2u) + far_side) * (1 << position_bits));
    precise vec3 times =
        mix((face - origin) / direction, vec3(-1e30), equal(lattice_direction, ivec3(0)));
    precise vec3 point = origin + direction * max(max(times.x, times.y), times.z);
    precise float metres = dot(depth_per_step.xyz, point) + depth_per_step.w;
    precise float depth = (depth_from_metres.x * metres + depth_from_metres.y) /
                          (depth_from_metres.z * metres + depth_from_metres.w);
    return clamp(depth, 0.0, billboard_depth);
}
