// Rays of the voxel view: quantised where they come into the model's box, then walked exactly (see
// ray_walk.glsl), so that no ray slips between two cells and every driver finds the same voxels
// for the same start and direction.
//
// Who includes this includes octree_block.glsl and voxel_view.glsl before. Positions are in voxels
// from the middle of the root cube.

// DEPTH_LIMIT: nodes of edge 2^view_leaf_level are the smallest cubes.
#ifdef DEPTH_LIMIT
#define LEAF_LEVEL view_leaf_level
#endif

#include "shared/ray_walk.glsl"

struct Hit {
    uint material;
    int axis;
    float t;
    ivec3 cell;  // tree coordinates
};

float largest(vec3 v) {
    return max(max(v.x, v.y), v.z);
}

ivec3 latticePosition(vec3 at) {
    float steps = float(1 << (kRayEdgeBits - int(svo_max_depth)));
    return ivec3(round(at * steps)) + (1 << (kRayEdgeBits - 1));
}

ivec3 latticeDirection(vec3 direction, float scale) {
    return ivec3(round(direction * (float(1 << kRayDirectionBits) / scale)));
}

// When the ray comes to the box's near faces, or `nearest`; at axes along which it does not move, too.
vec3 entryTimes(vec3 origin, vec3 direction, vec3 low, vec3 high, float nearest) {
    vec3 times = (mix(low, high, lessThan(direction, vec3(0.0))) - origin) / direction;
    return mix(times, vec3(nearest), equal(direction, vec3(0.0)));
}

// The first voxel that the ray meets from `nearest` on.
Hit castRay(vec3 origin, vec3 direction, float nearest, out Cursor cursor) {
    Hit hit = Hit(0u, 0, nearest, ivec3(0));
    int middle = 1 << (int(svo_max_depth) - 1);
    vec3 low = vec3(view_box_low - middle);
    vec3 high = vec3(view_box_high - middle);
    float enter = max(largest(entryTimes(origin, direction, low, high, nearest)), nearest);
    vec3 start = origin + direction * enter;
    // Rounding moves the line by far less than a voxel: it would miss as well.
    if (any(lessThan(start, low - 1.0)) || any(greaterThan(start, high + 1.0))) {
        startAtRoot(cursor);
        return hit;
    }
    vec3 size = abs(direction);
    float scale = largest(size);
    Meeting met = castQuantised(latticePosition(start), latticeDirection(direction, scale),
                                enter == nearest, view_box_low, view_box_high, cursor);
    if (met.material == 0u) return hit;
    hit.material = met.material;
    hit.cell = met.cell;
    if (met.axis == 3) {
        hit.axis = size.x == scale ? 0 : size.y == scale ? 1 : 2;
        return hit;
    }
    hit.axis = met.axis;
    int node = met.cell[hit.axis] >> leafLevel();
    int face = (direction[hit.axis] < 0.0 ? node + 1 : node) << leafLevel();
    hit.t = (float(face - middle) - origin[hit.axis]) / direction[hit.axis];
    // A ray that grazes a face may meet its plane elsewhere than the line walked does.
    float walked = enter + float(met.crossing.numerator / met.crossing.denominator) *
                               (float(1 << kRayDirectionBits) /
                                (scale * float(1 << position_bits)));
    if (abs(hit.t - walked) * scale > 0.25) hit.t = walked;
    return hit;
}

// Does a voxel stand between a point of `cell`, which is empty, and the sun? Starting inside the
// cell that the face looks into, the walk cannot meet the face's own voxel.
bool inShadow(vec3 at, ivec3 cell, inout Cursor cursor) {
    if (any(lessThan(cell, view_box_low)) || any(greaterThanEqual(cell, view_box_high))) {
        return false;
    }
    position_bits = kRayEdgeBits - int(svo_max_depth);
    mirrorLines(latticeDirection(sun.xyz, largest(abs(sun.xyz))), view_box_low, view_box_high,
                ivec3(0));
    ivec3 start = clamp(latticePosition(at), (cell << position_bits) + 1,
                        ((cell + 1) << position_bits) - 1);
    Crossing here = Crossing(3, 0.0LF, 1.0LF);
    return walkLine(here, dvec3(mirror_sign * start), cursor).material != 0u;
}
