// The colour of a voxel's face where an eye ray meets it: its light, shade, shadow and edges.
//
// Who includes this includes octree_block.glsl, octree.glsl, voxel_view.glsl and voxel_walk.glsl
// before.

#include "shared/face_shade.glsl"

// Column = material, row = face: +x, +y, +z, -x, -y, -z; in a sprite's own light six for each kind
// of shade.
layout(binding = 1) uniform sampler2D palette_texture;

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

// 1 where the cell is solid.
float solidAt(ivec3 cell, inout Cursor cursor) {
    if (any(lessThan(cell, view_box_low)) || any(greaterThanEqual(cell, view_box_high))) return 0.0;
    return regionAt(cell, cursor).material != 0u ? 1.0 : 0.0;
}

// Which cells around `middle` are solid, of those wanted: a bit each, row by row along u, then v.
// Looked up in one place: drivers take long to compile the same again and again.
uint solidAround(ivec3 middle, ivec3 u, ivec3 v, uint wanted, inout Cursor cursor) {
    uint solid = 0u;
    for (int k = 0; k < 9; ++k) {
        if (((wanted >> k) & 1u) == 0u) continue;
        if (solidAt(middle + u * (k % 3 - 1) + v * (k / 3 - 1), cursor) > 0.0) solid |= 1u << k;
    }
    return solid;
}

float bitOf(uint bits, int k) {
    return float((bits >> k) & 1u);
}

float cornerOcclusion(float side_a, float side_b, float corner) {
    return side_a * side_b > 0.0 ? 1.0 : (side_a + side_b + corner) / 3.0;
}

// Corners where other voxels stand up from a face lie in their shade (Lysenko 2013).
float cornerShade(Hit hit, bool faces_up, vec2 position, inout Cursor cursor) {
    ivec3 unit = axisUnit(hit.axis);
    ivec3 front = hit.cell + (faces_up ? unit : -unit);
    ivec3 u = hit.axis == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
    ivec3 v = hit.axis == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    uint solid = solidAround(front, u, v, 0x1EFu, cursor);
    float left = bitOf(solid, 3);
    float right = bitOf(solid, 5);
    float below = bitOf(solid, 1);
    float above = bitOf(solid, 7);
    vec4 corners = vec4(cornerOcclusion(left, below, bitOf(solid, 0)),
                        cornerOcclusion(right, below, bitOf(solid, 2)),
                        cornerOcclusion(left, above, bitOf(solid, 6)),
                        cornerOcclusion(right, above, bitOf(solid, 8)));
    vec2 at = fract(position);
    vec2 rows = mix(corners.xz, corners.yw, at.x);
    return mix(rows.x, rows.y, at.y);
}

// FACE_SHADE: faces cast rays of their own; SUN_SHADOW: they look for the sun. Compiled in only
// where it is asked for: a rasteriser that runs lanes together pays for what they skip, too, and
// drivers take long to compile a walk through the octree.
#ifdef FACE_SHADE
// The share of the face's short rays that are blocked.
float blockedShare(ivec3 cell, int axis, ivec3 outward, inout Cursor cursor) {
    int side = outward.x + outward.y + outward.z;
    return float(blockedRays(cell + outward, axis, side, cursor)) / float(kOcclusionRays);
}

// The same for a face beside it; where none is in sight, `otherwise`.
float blockedBeside(ivec3 cell, int axis, ivec3 outward, float otherwise, inout Cursor cursor) {
    bool there = solidAt(cell, cursor) > 0.0 && solidAt(cell + outward, cursor) == 0.0;
    return there ? blockedShare(cell, axis, outward, cursor) : otherwise;
}

// What the middles of this face and of those beside it see, and between them a blend: smooth over
// walls and floors.
float rayOcclusion(Hit hit, bool faces_up, vec2 position, inout Cursor cursor) {
    ivec3 outward = axisUnit(hit.axis) * (faces_up ? 1 : -1);
    vec2 from_middle = fract(position) - 0.5;
    ivec3 u = (hit.axis == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0)) * (from_middle.x < 0.0 ? -1 : 1);
    ivec3 v = (hit.axis == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1)) * (from_middle.y < 0.0 ? -1 : 1);
    float own = blockedShare(hit.cell, hit.axis, outward, cursor);
    float beside = blockedBeside(hit.cell + u, hit.axis, outward, own, cursor);
    float above = blockedBeside(hit.cell + v, hit.axis, outward, own, cursor);
    float across = blockedBeside(hit.cell + u + v, hit.axis, outward, 0.5 * (beside + above), cursor);
    vec2 share = abs(from_middle);
    return mix(mix(own, beside, share.x), mix(above, across, share.x), share.y);
}

// Which of a sprite's colours the face has: as shadedRow of sprites.
int spriteState(Hit hit, bool faces_up, inout Cursor cursor) {
    int side = faces_up ? 1 : -1;
    ivec3 front = hit.cell + axisUnit(hit.axis) * side;
    int state = 0;
    if (sprite_rays.w != 0) {
        state = occlusionLevel(blockedRays(front, hit.axis, side, cursor));
    }
    if (sprite_rays.xyz != ivec3(0) &&
        faceInShadow(front, hit.axis, side, sprite_rays.xyz, cursor)) {
        state += kOcclusionLevels;
    }
    return state;
}
#endif

// The point of the face that the pixel shows, and how far the pixel reaches on it.
struct FacePoint {
    vec3 at;
    vec2 position;   // across the face
    vec2 footprint;  // of the pixel, in voxels
    bool faces_up;
};

FacePoint facePoint(Hit hit, vec2 screen, vec3 origin, vec3 direction) {
    FacePoint point;
    point.faces_up = along(direction, hit.axis) < 0.0;
    point.at = origin + direction * hit.t;
    point.position = across(point.at, hit.axis);
    float face = round(along(point.at, hit.axis));
    vec2 dx = onPlane(screen + vec2(1, 0), hit.axis, face) - point.position;
    vec2 dy = onPlane(screen + vec2(0, 1), hit.axis, face) - point.position;
    point.footprint = sqrt(dx * dx + dy * dy);
    return point;
}

vec3 voxelColour(Hit hit, FacePoint point, inout Cursor cursor) {
    int row = point.faces_up ? hit.axis : hit.axis + 3;
#ifdef FACE_SHADE
    row += 6 * spriteState(hit, point.faces_up, cursor);
#endif
    vec3 base = texelFetch(palette_texture, ivec2(int(hit.material), row), 0).rgb;
    float light = point.faces_up ? face_light[hit.axis].x : face_light[hit.axis].y;
    float large = max(point.footprint.x, point.footprint.y);
#ifdef SUN_SHADOW
    ivec3 unit = axisUnit(hit.axis);
    // What looks away from the sun is in its own shade already.
    bool sunlit = along(sun.xyz, hit.axis) * (point.faces_up ? 1.0 : -1.0) > 0.0;
    if (sun.w > 0.0 && sunlit &&
        inShadow(point.at, hit.cell + (point.faces_up ? unit : -unit), cursor)) {
        light *= 1.0 - sun.w;
    }
#endif
    if (occlusion_shown != 0 && large < 1.0) {
#ifdef FACE_SHADE
        float lost =
            occlusion_shown == 1
                ? 0.4 * cornerShade(hit, point.faces_up, point.position, cursor)
                : 0.7 * rayOcclusion(hit, point.faces_up, point.position, cursor);
#else
        float lost = 0.4 * cornerShade(hit, point.faces_up, point.position, cursor);
#endif
        light *= 1.0 - lost * (1.0 - smoothstep(0.5, 1.0, large));
    }
    if (edges_shown != 0) {
        float cube = float(1 << leafLevel());
        light *= 1.0 - 0.16 * edgeShade(point.position / cube, point.footprint / cube);
    }
    return base * light;
}

float depthAt(float t) {
    return (view_depth_from_t.x * t + view_depth_from_t.y) /
           (view_depth_from_t.z * t + view_depth_from_t.w);
}
