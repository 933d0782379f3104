// A perspective (or parallel) ray through the octree, in floating point.
//
// The walk keeps an integer cell and takes every time of crossing anew from the face's position, so
// that errors do not grow; where it leaves a node its cell is clamped to that node. So a ray cannot
// slip between two cells (Amanatides & Woo 1987).

#include "shared/octree.glsl"
#include "shared/voxel_view.glsl"

layout(binding = 1) uniform sampler2D palette_texture;

layout(location = 0) out vec4 colour;

struct Hit {
    uint material;
    int axis;
    float t;
};

// Directions run upwards on every axis, mirrored as in the lattice caster.
Hit castRay(vec3 origin, vec3 direction) {
    int edge = 1 << int(svo_max_depth);
    int middle = edge >> 1;
    bvec3 mirrored = lessThan(direction, vec3(0.0));
    ivec3 bits = ivec3(mirrored) * (edge - 1);
    ivec3 low = mix(view_box_low, edge - view_box_high, mirrored);
    ivec3 high = mix(view_box_high, edge - view_box_low, mirrored);
    origin = mix(origin, -origin, mirrored);
    direction = max(abs(direction), vec3(1e-12));
    vec3 inverse = 1.0 / direction;

    Hit hit = Hit(0u, 0, near_metres);
    vec3 enter = (vec3(low - middle) - origin) * inverse;
    vec3 leave = (vec3(high - middle) - origin) * inverse;
    float t = max(max(enter.x, enter.y), enter.z);
    if (t > min(min(leave.x, leave.y), leave.z)) return hit;
    if (t > near_metres) {
        hit.axis = t == enter.x ? 0 : t == enter.y ? 1 : 2;
        hit.t = t;
    } else {
        vec3 steepest = direction;
        hit.axis = steepest.x >= max(steepest.y, steepest.z) ? 0 : steepest.y >= steepest.z ? 1 : 2;
    }
    ivec3 cell = clamp(ivec3(floor(origin + direction * hit.t)) + middle, low, high - 1);

    Cursor cursor;
    startAtRoot(cursor);
    do {
        Region region = regionAt(cell ^ bits, cursor);
        if (region.material != 0u) {
            hit.material = region.material;
            return hit;
        }
        ivec3 ends = min(((cell >> region.shift) + 1) << region.shift, high);
        vec3 times = (vec3(ends - middle) - origin) * inverse;
        hit.axis = times.x <= min(times.y, times.z) ? 0 : times.y <= times.z ? 1 : 2;
        hit.t = hit.axis == 0 ? times.x : hit.axis == 1 ? times.y : times.z;
        ivec3 next = clamp(ivec3(floor(origin + direction * hit.t)) + middle, cell, ends - 1);
        cell = mix(next, ends, equal(ivec3(hit.axis), ivec3(0, 1, 2)));
    } while (all(lessThan(cell, high)));
    return hit;
}

// The two coordinates on a face.
vec2 across(vec3 v, int axis) {
    return axis == 0 ? v.yz : axis == 1 ? v.xz : v.xy;
}

float along(vec3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// Where the ray of a neighbouring pixel meets the plane of the same face.
vec2 onPlane(vec2 screen, int axis, float face) {
    vec3 o = voxelRayOrigin(screen);
    vec3 d = voxelRayDirection(screen);
    return across(o + d * ((face - along(o, axis)) / along(d, axis)), axis);
}

// A thin line along voxel edges, gone before it could shimmer.
float edgeShade(vec2 position, vec2 footprint) {
    float wide = max(footprint.x, footprint.y);
    vec2 inside = abs(fract(position) - 0.5);
    vec2 line_width = max(vec2(0.035), 0.75 * footprint);
    vec2 line = smoothstep(0.5 - line_width - 0.5 * footprint, 0.5 - line_width + 0.5 * footprint,
                           inside);
    return max(line.x, line.y) * (1.0 - smoothstep(0.08, 0.28, wide));
}

void main() {
    vec2 screen = gl_FragCoord.xy;
    vec3 origin = voxelRayOrigin(screen);
    vec3 direction = voxelRayDirection(screen);
    Hit hit = castRay(origin, direction);
    if (hit.material == 0u) discard;

    vec4 lights = face_light[hit.axis];
    vec3 base = texelFetch(palette_texture, ivec2(int(hit.material), 0), 0).rgb;
    float light = along(direction, hit.axis) < 0.0 ? lights.x : lights.y;
    if (edges_shown != 0) {
        vec3 at = origin + direction * hit.t;
        vec2 position = across(at, hit.axis);
        float face = round(along(at, hit.axis));
        vec2 dx = onPlane(screen + vec2(1, 0), hit.axis, face) - position;
        vec2 dy = onPlane(screen + vec2(0, 1), hit.axis, face) - position;
        light *= 1.0 - 0.16 * edgeShade(position, sqrt(dx * dx + dy * dy));
    }
    colour = vec4(base * light, 1.0);
    gl_FragDepth = (view_depth_from_t.x * hit.t + view_depth_from_t.y) /
                   (view_depth_from_t.z * hit.t + view_depth_from_t.w);
}
