// The voxels, lit and shaded where a ray of the eye meets them.

#include "shared/octree_block.glsl"
#include "shared/octree.glsl"
#include "shared/voxel_view.glsl"
#include "shared/voxel_walk.glsl"

// Column = material, row = face: +x, +y, +z, -x, -y, -z.
layout(binding = 1) uniform sampler2D palette_texture;

layout(location = 0) out vec4 colour;

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

float cornerOcclusion(float side_a, float side_b, float corner) {
    return side_a * side_b > 0.0 ? 1.0 : (side_a + side_b + corner) / 3.0;
}

// Corners where other voxels stand up from a face lie in their shade (Lysenko 2013).
float occlusion(Hit hit, bool faces_up, vec2 position, inout Cursor cursor) {
    ivec3 unit = ivec3(equal(ivec3(hit.axis), ivec3(0, 1, 2)));
    ivec3 front = hit.cell + (faces_up ? unit : -unit);
    ivec3 u = hit.axis == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
    ivec3 v = hit.axis == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    float left = solidAt(front - u, cursor);
    float right = solidAt(front + u, cursor);
    float below = solidAt(front - v, cursor);
    float above = solidAt(front + v, cursor);
    vec4 corners = vec4(cornerOcclusion(left, below, solidAt(front - u - v, cursor)),
                        cornerOcclusion(right, below, solidAt(front + u - v, cursor)),
                        cornerOcclusion(left, above, solidAt(front - u + v, cursor)),
                        cornerOcclusion(right, above, solidAt(front + u + v, cursor)));
    vec2 at = fract(position);
    vec2 rows = mix(corners.xz, corners.yw, at.x);
    return mix(rows.x, rows.y, at.y);
}

// The opacity of a line along those edges of the face at which the voxels end.
float outline(Hit hit, vec2 position, vec2 footprint, inout Cursor cursor) {
    ivec3 u = hit.axis == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
    ivec3 v = hit.axis == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    vec2 low = 1.0 - vec2(solidAt(hit.cell - u, cursor), solidAt(hit.cell - v, cursor));
    vec2 high = 1.0 - vec2(solidAt(hit.cell + u, cursor), solidAt(hit.cell + v, cursor));
    vec2 at_px = fract(position) / footprint;
    vec2 end_px = (1.0 - fract(position)) / footprint;
    vec2 line = max(low * clamp(ghost_outline_px + 0.5 - at_px, 0.0, 1.0),
                    high * clamp(ghost_outline_px + 0.5 - end_px, 0.0, 1.0));
    return max(line.x, line.y);
}

vec4 ghostColour(vec3 shaded, float line) {
    vec4 tinted = vec4(mix(shaded, ghost_tint.rgb, ghost_mixed), ghost_tint.a);
    // Light and dark in turn, so that the line shows on every colour.
    bool dark = mod(gl_FragCoord.x + gl_FragCoord.y, 2.0 * ghost_dash_px) < ghost_dash_px;
    vec4 dash = vec4(vec3(dark ? 0.08 : 1.0), min(1.0, 3.0 * ghost_tint.a));
    return mix(tinted, dash, line);
}

void main() {
    vec2 screen = gl_FragCoord.xy;
    vec3 origin = voxelRayOrigin(screen);
    vec3 direction = voxelRayDirection(screen);
    Cursor cursor;
    Hit hit = castRay(origin, direction, near_metres, cursor);
    if (hit.material == 0u) discard;

    bool faces_up = along(direction, hit.axis) < 0.0;
    int row = faces_up ? hit.axis : hit.axis + 3;
    vec3 base = texelFetch(palette_texture, ivec2(int(hit.material), row), 0).rgb;
    vec3 at = origin + direction * hit.t;
    vec2 position = across(at, hit.axis);
    float face = round(along(at, hit.axis));
    vec2 dx = onPlane(screen + vec2(1, 0), hit.axis, face) - position;
    vec2 dy = onPlane(screen + vec2(0, 1), hit.axis, face) - position;
    vec2 footprint = sqrt(dx * dx + dy * dy);
    float light = faces_up ? face_light[hit.axis].x : face_light[hit.axis].y;
    float large = max(footprint.x, footprint.y);
    ivec3 unit = ivec3(equal(ivec3(hit.axis), ivec3(0, 1, 2)));
    // What looks away from the sun is in its own shade already.
    bool sunlit = along(sun.xyz, hit.axis) * (faces_up ? 1.0 : -1.0) > 0.0;
    if (sun.w > 0.0 && sunlit &&
        inShadow(at, hit.cell + (faces_up ? unit : -unit), cursor)) {
        light *= 1.0 - sun.w;
    }
    if (occlusion_shown != 0 && large < 1.0) {
        light *= 1.0 - 0.4 * occlusion(hit, faces_up, position, cursor) *
                           (1.0 - smoothstep(0.5, 1.0, large));
    }
    if (edges_shown != 0) light *= 1.0 - 0.16 * edgeShade(position, footprint);
    colour = vec4(base * light, 1.0);
    gl_FragDepth = (view_depth_from_t.x * hit.t + view_depth_from_t.y) /
                   (view_depth_from_t.z * hit.t + view_depth_from_t.w);
    if (ghost_tint.a > 0.0) {
        float line =
            ghost_outline_px > 0.0 ? outline(hit, position, footprint, cursor) : 0.0;
        colour = ghostColour(colour.rgb, line);
        gl_FragDepth = min(1.0, gl_FragDepth * ghost_nearer);
    }
}
