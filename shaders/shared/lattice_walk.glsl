// How a line of integers walks an octree: the twin of core/trace/octree_walk, bit for bit.
//
// Each axis on which the lines run downwards is mirrored about the root cube, so that every line
// runs upwards: cell c becomes c ^ (edge - 1), position x becomes edge - x. The rules of
// core/trace/lattice.h are symmetric under that, and their order among axes does not change.
// Positions are taken from a corner (`box_centre`) to keep products small: sprites that fit 31 bits
// take their model's middle. LATTICE_WIDE computes in doubles, which hold integers below 2^53.
//
// Who includes this includes lattice_point.glsl (for Number) and octree.glsl before, and declares
// int position_bits.

// What all lines along one direction share; in mirrored tree coordinates.
ivec3 speed;        // |D|
ivec3 mirror_sign;  // -1 where mirrored
ivec3 mirror_bits;  // edge - 1 where mirrored
ivec3 box_low;      // the box that is walked
ivec3 box_high;
ivec3 box_centre;  // what positions count from
#ifdef LATTICE_WIDE
dvec3 cells_per_time;  // 1 / (|D| * 2^position_bits)
#endif

// `low`, `high` and `centre` in tree coordinates.
void mirrorLines(ivec3 direction, ivec3 low, ivec3 high, ivec3 centre) {
    int edge = 1 << int(svo_max_depth);
    bvec3 mirrored = lessThan(direction, ivec3(0));
    speed = abs(direction);
    mirror_sign = mix(ivec3(1), ivec3(-1), mirrored);
    mirror_bits = mix(ivec3(0), ivec3(edge - 1), mirrored);
    box_low = mix(low, edge - high, mirrored);
    box_high = mix(high, edge - low, mirrored);
    box_centre = mix(centre, edge - centre, mirrored);
#ifdef LATTICE_WIDE
    cells_per_time = 1.0LF / (dvec3(max(speed, 1)) * double(1 << position_bits));
#endif
}

// The time at which an axis is crossed is numerator / speed of that axis. Axis 3 stands for a time
// at which everything is crossed that the line meets then.
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

// Where the line is right after a crossing: floor((O_b * D_a + N_a * D_b) / (D_a * 2^P)) on each
// axis b. An axis above the crossed one has not yet crossed a face that it meets at the same time:
// there the face does not count (ceil - 1, not floor).
ivec3 cellAfter(Crossing crossing, Number3 origin) {
    ivec3 later = ivec3(greaterThan(ivec3(0, 1, 2), ivec3(crossing.axis))) *
                  min(speed, ivec3(1));
#ifdef LATTICE_WIDE
    // Between two multiples of D_a * 2^P: half a unit aside no quotient is near a whole number, and
    // rounding (2^-51) cannot reach one across a gap of at least 2^-46.
    double scale = crossing.axis == 0   ? cells_per_time.x
                   : crossing.axis == 1 ? cells_per_time.y
                   : crossing.axis == 2 ? cells_per_time.z
                                        : 1.0LF / double(1 << position_bits);
    dvec3 at = origin * crossing.denominator + dvec3(speed) * crossing.numerator +
               (0.5LF - dvec3(later));
    // A line that misses by far may be beyond the integers; it stays outside all the same.
    return box_centre + ivec3(clamp(floor(at * scale), -1e9LF, 1e9LF));
#else
    // From an approximate quotient, and one exact step of correction.
    ivec3 x = speed * crossing.numerator - later;
    ivec3 quotient = ivec3(floor(vec3(x) / float(crossing.denominator)));
    ivec3 rest = x - quotient * crossing.denominator;
    quotient += ivec3(greaterThanEqual(rest, ivec3(crossing.denominator))) -
                ivec3(lessThan(rest, ivec3(0)));
    return box_centre + ((origin + quotient) >> position_bits);
#endif
}

struct Meeting {
    uint material;  // 0: nothing was met
    int axis;
    ivec3 cell;  // tree coordinates, not mirrored
    Crossing crossing;
};

// The first solid cell of the box from the one behind a crossing on.
Meeting walkLine(Crossing crossing, Number3 origin, inout Cursor cursor) {
    Meeting met = Meeting(0u, 0, ivec3(0), crossing);
    ivec3 cell = cellAfter(crossing, origin);
    if (any(lessThan(cell, box_low))) return met;
    while (all(lessThan(cell, box_high))) {
        ivec3 tree_cell = cell ^ mirror_bits;
        Region region = regionAt(tree_cell, cursor);
        if (region.material != 0u) {
            return Meeting(region.material, crossing.axis, tree_cell, crossing);
        }
        ivec3 ends = min(((cell >> region.shift) + 1) << region.shift, box_high);
        crossing = earliest(ends, origin);
        cell = cellAfter(crossing, origin);
    }
    return met;
}
