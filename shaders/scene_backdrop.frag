// Behind the sprites: the sky, and the ground with its depth.

#include "shared/camera.glsl"
#include "shared/grid.glsl"

// The distance to the ground is computed in doubles: a sprite that stands on it is hidden or not by
// the last bits of a depth.
layout(std140, binding = 4) uniform BackdropBlock {
    dvec4 ground_rise;      // height of the ground over the ray's start: of (x, y, 1)
    dvec4 ground_descent;   // the ray's rise for each metre ahead, likewise
    dvec4 ground_depth;     // depth = (x * t + y) / (z * t + w)
    vec4 ground_colour;
    vec4 sky_zenith;
    vec4 sky_horizon;
    vec2 eye_on_grid;       // the eye's x and z, modulo ten metres
    float ground_near_metres;
    float haze_metres;      // where the ground has mostly become sky; 0: no haze
    int sky_shown;
    int ground_shown;
    int grid_shown;
};

layout(location = 0) out vec4 colour;

vec3 skyColour(vec3 direction) {
    float rise = normalize(direction).y;
    return mix(sky_horizon.rgb, sky_zenith.rgb, smoothstep(0.0, 0.55, rise));
}

vec3 groundColour(vec2 hit, vec2 footprint, float metres) {
    vec3 ground = ground_colour.rgb;
    if (grid_shown != 0) {
        float fade = exp(-metres * 0.02);
        float fine = gridCoverage(hit, 1.0, 0.02, footprint);
        float coarse = gridCoverage(hit, 5.0, 0.04, footprint);
        ground = mix(ground, ground * 0.78, max(0.55 * fine, coarse) * fade);
    }
    return ground;
}

void main() {
    dvec3 screen = dvec3(dvec2(gl_FragCoord.xy) - 0.5LF * dvec2(viewport_px), 1.0LF);
    double metres = dot(ground_rise.xyz, screen) / dot(ground_descent.xyz, screen);
    float t = float(metres);
    vec3 origin = eyeRayOrigin(gl_FragCoord.xy);
    vec3 direction = eyeRayDirection(gl_FragCoord.xy);
    vec2 hit = eye_on_grid + origin.xz + direction.xz * t;
    vec2 footprint = fwidth(hit);
    gl_FragDepth = 0.0;
    if (ground_shown != 0 && t >= ground_near_metres) {
        vec3 ground = groundColour(hit, footprint, t);
        if (haze_metres > 0.0) {
            float haze = 1.0 - exp(-max(0.0, t / haze_metres - 0.2));
            ground = mix(ground, sky_horizon.rgb, haze);
        }
        colour = vec4(ground, ground_colour.a);
        gl_FragDepth = float((ground_depth.x * metres + ground_depth.y) /
                             (ground_depth.z * metres + ground_depth.w));
        return;
    }
    if (sky_shown == 0) discard;
    colour = vec4(skyColour(direction), 1.0);
}
