// The integer lattice caster: the twin of core/trace/lattice_caster, bit for bit.
//
// Each axis on which the rays run downwards is mirrored about the root cube, so that every ray runs
// upwards: cell c becomes c ^ (edge - 1), position x becomes edge - x. The rules of
// core/trace/lattice.h are symmetric under that, and their order among axes does not change.
// Positions are taken from the model's centre corner, floor(size / 2), to keep products small:
// 31 bits for common models; LATTICE_WIDE computes in doubles, which hold integers below 2^53.

#include "shared/lattice_point.glsl"
#include "shared/ray_varyings.glsl"
#include "shared/octree.glsl"

// The rays and the box that they meet, mirrored; in tree coordinates.
ivec3 speed;        // |D|
ivec3 mirror_sign;  // -1 where mirrored
ivec3 mirror_bits;  // edge - 1 where mirrored
ivec3 box_low;      // the model's box inside the root cube
ivec3 box_high;
ivec3 box_centre;  // the centre corner

void mirrorRays() {
    int edge = 1 << int(svo_max_depth);
    ivec3 size = ivec3(svo_model_size);
    ivec3 low = clamp(tree_from_voxel, 0, edge);
    ivec3 high = clamp(tree_from_voxel + size, 0, edge);
    ivec3 middle = tree_from_voxel + size / 2;
    bvec3 mirrored = lessThan(lattice_direction, ivec3(0));
    speed = abs(lattice_direction);
    mirror_sign = mix(ivec3(1), ivec3(-1), mirrored);
    mirror_bits = mix(ivec3(0), ivec3(edge - 1), mirrored);
    box_low = mix(low, edge - high, mirrored);
    box_high = mix(high, edge - low, mirrored);
    box_centre = mix(middle, edge - middle, mirrored);
}

struct LatticeHit {
    uint material;  // 0: nothing was hit
    int face_axis;
    ivec3 voxel;
};

// floor(x / m) for m > 0, from an approximate quotient and one exact step of correction.
Number3 floorDivide(Number3 x, Number m) {
#ifdef LATTICE_WIDE
    Number3 quotient = floor(x / m);
#else
    Number3 quotient = ivec3(floor(vec3(x) / float(m)));
#endif
    Number3 rest = x - quotient * m;
    return quotient - Number3(lessThan(rest, Number3(0))) +
           Number3(greaterThanEqual(rest, Number3(m)));
}

// The cell that holds a position, from the centre corner.
ivec3 cellOf(Number3 position) {
#ifdef LATTICE_WIDE
    // A ray that misses by far may be beyond the integers; it stays outside all the same.
    return ivec3(clamp(floor(position / double(1 << position_bits)), -1e9LF, 1e9LF));
#else
    return position >> position_bits;
#endif
}

Number3 rayOrigin(ivec2 pixel) {
    return Number3(mirror_sign) * latticePoint(lattice_origin, lattice_right, lattice_up, pixel);
}

// The time at which an axis is crossed is numerator / speed of that axis.
struct Crossing {
    int axis;
    Number numerator;
    Number denominator;
};

// The numerators for the three faces at `face`; `still` for an axis along which nothing moves.
Number3 numerators(ivec3 face, Number3 origin, Number still) {
    Number3 n = Number3(face - box_centre) * Number(1 << position_bits) - origin;
    return mix(n, Number3(still), equal(speed, ivec3(0)));
}

// Ties go to the lowest axis first: so the earliest of equals is the lowest axis ...
Crossing earliest(ivec3 face, Number3 origin) {
    Number3 n = numerators(face, origin, Number(1));
    Number3 d = Number3(speed);
    Crossing best = Crossing(0, n.x, d.x);
    if (n.y * best.denominator < best.numerator * d.y) best = Crossing(1, n.y, d.y);
    if (n.z * best.denominator < best.numerator * d.z) best = Crossing(2, n.z, d.z);
    return best;
}

// ... and the latest the highest.
Crossing latest(ivec3 face, Number3 origin) {
    Number3 n = numerators(face, origin, Number(-1));
    Number3 d = Number3(speed);
    Crossing best = Crossing(0, n.x, d.x);
    if (n.y * best.denominator >= best.numerator * d.y) best = Crossing(1, n.y, d.y);
    if (n.z * best.denominator >= best.numerator * d.z) best = Crossing(2, n.z, d.z);
    return best;
}

// Where the line is right after a crossing. An axis above the crossed one has not yet crossed a
// face that it meets at the same time: there the face does not count (ceil - 1, not floor).
ivec3 cellAfter(Crossing crossing, Number3 origin) {
    ivec3 later = ivec3(greaterThan(ivec3(0, 1, 2), ivec3(crossing.axis))) *
                  min(speed, ivec3(1));
    Number3 moved = floorDivide(
        Number3(speed) * crossing.numerator - Number3(later), crossing.denominator);
    return box_centre + cellOf(origin + moved);
}

LatticeHit castLattice(ivec2 pixel) {
    LatticeHit hit = LatticeHit(0u, 0, ivec3(0));
    mirrorRays();
    Number3 origin = rayOrigin(pixel);
    Crossing crossing = latest(box_low, origin);
    ivec3 cell = cellAfter(crossing, origin);
    if (any(lessThan(cell, box_low))) return hit;

    Cursor cursor;
    startAtRoot(cursor);
    while (all(lessThan(cell, box_high))) {
        ivec3 tree_cell = cell ^ mirror_bits;
        Region region = regionAt(tree_cell, cursor);
        if (region.material != 0u) {
            return LatticeHit(region.material, crossing.axis, tree_cell - tree_from_voxel);
        }
        ivec3 ends = min(((cell >> region.shift) + 1) << region.shift, box_high);
        crossing = earliest(ends, origin);
        cell = cellAfter(crossing, origin);
    }
    return hit;
}

uint voxelId(LatticeHit hit) {
    uvec3 v = uvec3(hit.voxel);
    return 2u + v.x + svo_model_size.x * (v.y + svo_model_size.y * v.z);
}
