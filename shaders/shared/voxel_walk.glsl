// A perspective (or parallel) ray through the octree, in floating point.
//
// The walk keeps an integer cell and takes every time of crossing anew from the face's position, so
// that errors do not grow; where it leaves a node its cell is clamped to that node. So a ray cannot
// slip between two cells (Amanatides & Woo 1987).
//
// Who includes this includes octree_block.glsl, octree.glsl and voxel_view.glsl before.

struct Hit {
    uint material;
    int axis;
    float t;
    ivec3 cell;  // tree coordinates
};

// A ray mirrored so that it runs upwards on every axis, as in the lattice caster; `bits` mirrors
// cells. [low, high) is the model.
struct Ray {
    vec3 origin;
    vec3 direction;
    vec3 inverse;
    ivec3 bits, low, high;
    int middle;
};

Ray rayFrom(vec3 origin, vec3 direction) {
    Ray ray;
    int edge = 1 << int(svo_max_depth);
    bvec3 mirrored = lessThan(direction, vec3(0.0));
    ray.middle = edge >> 1;
    ray.bits = ivec3(mirrored) * (edge - 1);
    ray.low = mix(view_box_low, edge - view_box_high, mirrored);
    ray.high = mix(view_box_high, edge - view_box_low, mirrored);
    ray.origin = mix(origin, -origin, mirrored);
    ray.direction = max(abs(direction), vec3(1e-12));
    ray.inverse = 1.0 / ray.direction;
    return ray;
}

// On from a (mirrored) cell, into which the ray comes through `hit.axis` at `hit.t`.
Hit walk(Ray ray, ivec3 cell, Hit hit, inout Cursor cursor) {
    do {
        Region region = regionAt(cell ^ ray.bits, cursor);
        if (region.material != 0u) {
            hit.material = region.material;
            hit.cell = cell ^ ray.bits;
            return hit;
        }
        ivec3 ends = min(((cell >> region.shift) + 1) << region.shift, ray.high);
        vec3 times = (vec3(ends - ray.middle) - ray.origin) * ray.inverse;
        hit.axis = times.x <= min(times.y, times.z) ? 0 : times.y <= times.z ? 1 : 2;
        hit.t = hit.axis == 0 ? times.x : hit.axis == 1 ? times.y : times.z;
        ivec3 next = clamp(ivec3(floor(ray.origin + ray.direction * hit.t)) + ray.middle, cell,
                           ends - 1);
        cell = mix(next, ends, equal(ivec3(hit.axis), ivec3(0, 1, 2)));
    } while (all(lessThan(cell, ray.high)));
    return hit;
}

// The first voxel that the ray meets from `nearest` on.
Hit castRay(vec3 origin, vec3 direction, float nearest, out Cursor cursor) {
    startAtRoot(cursor);
    Ray ray = rayFrom(origin, direction);
    Hit hit = Hit(0u, 0, nearest, ivec3(0));
    vec3 enter = (vec3(ray.low - ray.middle) - ray.origin) * ray.inverse;
    vec3 leave = (vec3(ray.high - ray.middle) - ray.origin) * ray.inverse;
    float t = max(max(enter.x, enter.y), enter.z);
    if (t > min(min(leave.x, leave.y), leave.z)) return hit;
    if (t > nearest) {
        hit.axis = t == enter.x ? 0 : t == enter.y ? 1 : 2;
        hit.t = t;
    } else {
        vec3 d = ray.direction;
        hit.axis = d.x >= max(d.y, d.z) ? 0 : d.y >= d.z ? 1 : 2;
    }
    ivec3 cell = clamp(ivec3(floor(ray.origin + ray.direction * hit.t)) + ray.middle, ray.low,
                       ray.high - 1);
    return walk(ray, cell, hit, cursor);
}

// Does a voxel stand between a point of `cell`, which is empty, and the sun? Starting in the cell
// that the face looks into, the walk cannot meet the face's own voxel.
bool inShadow(vec3 at, ivec3 cell, inout Cursor cursor) {
    Ray ray = rayFrom(at, sun.xyz);
    cell ^= ray.bits;
    if (any(lessThan(cell, ray.low)) || any(greaterThanEqual(cell, ray.high))) return false;
    return walk(ray, cell, Hit(0u, 0, 0.0, ivec3(0)), cursor).material != 0u;
}
