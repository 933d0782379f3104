// The voxels, lit and shaded where a ray of the eye meets them.

#include "shared/octree_block.glsl"
#include "shared/voxel_view.glsl"
#include "shared/voxel_walk.glsl"
#include "shared/voxel_shading.glsl"

layout(location = 0) out vec4 colour;

#ifdef MARKED
// Of a line between two faces that are both seen.
const float ghost_crease = 0.25;

// The opacity of a line along those edges of the face at which the voxels end: whole where the
// surface turns away from the eye, faint where it goes on around the corner, or every step of a
// curved surface would be as loud as its outline.
float outline(Hit hit, vec3 direction, vec2 position, vec2 footprint, inout Cursor cursor) {
    ivec3 u = hit.axis == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
    ivec3 v = hit.axis == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
    uint solid = solidAround(hit.cell, u, v, 0xAAu, cursor);
    vec2 low = 1.0 - vec2(bitOf(solid, 3), bitOf(solid, 1));
    vec2 high = 1.0 - vec2(bitOf(solid, 5), bitOf(solid, 7));
    vec2 toward = hit.axis == 0 ? direction.yz : hit.axis == 1 ? direction.xz : direction.xy;
    low *= mix(vec2(1.0), vec2(ghost_crease), greaterThan(toward, vec2(0.0)));
    high *= mix(vec2(1.0), vec2(ghost_crease), lessThan(toward, vec2(0.0)));
    vec2 at_px = fract(position) / footprint;
    vec2 end_px = (1.0 - fract(position)) / footprint;
    vec2 line = max(low * clamp(ghost_outline_px + 0.5 - at_px, 0.0, 1.0),
                    high * clamp(ghost_outline_px + 0.5 - end_px, 0.0, 1.0));
    return max(line.x, line.y);
}
#endif

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

    FacePoint point = facePoint(hit, screen, origin, direction);
#ifdef MARKED
    colour = vec4(1.0);  // all of it is the tint's
#else
    colour = vec4(voxelColour(hit, point, cursor), 1.0);
#endif
    gl_FragDepth = depthAt(hit.t);
    if (ghost_tint.a > 0.0) {
        float line = 0.0;
#ifdef MARKED
        if (ghost_outline_px > 0.0) {
            line = outline(hit, direction, point.position, point.footprint, cursor);
        }
#endif
        colour = ghostColour(colour.rgb, line);
        gl_FragDepth = min(1.0, gl_FragDepth * ghost_nearer);
    }
}
