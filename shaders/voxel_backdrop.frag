// Behind the voxels: a soft gradient, and on the plane under the model a grid and its shadow.

#include "shared/octree_block.glsl"
#include "shared/voxel_view.glsl"
#ifdef SUN_SHADOW
#include "shared/voxel_walk.glsl"
#endif
#include "shared/grid.glsl"

layout(location = 0) out vec4 colour;

void main() {
    vec2 screen = gl_FragCoord.xy;
    float height = screen.y / (2.0 * half_viewport_px.y);
    // A hash of the position hides the steps of eight bits.
    float noise = fract(52.9829189 * fract(dot(screen, vec2(0.06711056, 0.00583715)))) - 0.5;
    vec4 background = mix(background_bottom, background_top, smoothstep(0.0, 1.0, height));
    colour = vec4(background.rgb + noise / 255.0, 1.0);
    if (grid_shown == 0 && sun.w == 0.0) return;

    vec3 origin = voxelRayOrigin(screen);
    vec3 direction = voxelRayDirection(screen);
    float t = (grid_height - origin.z) / direction.z;
    vec2 hit = origin.xy + direction.xy * t;
    vec2 footprint = fwidth(hit);
    if (!(t > 0.0)) return;
    float from_centre = length(hit - grid_centre) / grid_radius;
    float fade = 1.0 - smoothstep(0.25, 1.0, from_centre);
    vec2 position = hit - grid_corner;
    float fine = 0.45 * gridCoverage(position, 1.0, 0.03, footprint);
    float coarse = gridCoverage(position, 8.0, 0.06, footprint);
    // Seen from below the plane must not stand before the model.
    float strength = origin.z + direction.z * near_metres > grid_height ? 1.0 : 0.35;
#ifdef SUN_SHADOW
    if (sun.w > 0.0 && sun.z > 0.0) {
        Cursor cursor;
        if (castRay(vec3(hit, grid_height), sun.xyz, 0.0, cursor).material != 0u) {
            colour.rgb *= 1.0 - 0.6 * sun.w * strength;
        }
    }
#endif
    if (grid_shown == 0) return;
    colour.rgb = mix(colour.rgb, grid_colour.rgb,
                     grid_colour.a * strength * fade * max(fine, coarse));
}
