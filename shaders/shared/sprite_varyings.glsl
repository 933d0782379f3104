// Of each sprite: where its pixels are on the screen and in the atlas.

#include "shared/flat_inputs.glsl"

Flat(0, 0) vec3 pixel_from_screen_x;
Flat(1, 0) vec3 pixel_from_screen_y;
Flat(2, 0) vec3 pixel_from_screen_1;
Flat(3, 0) vec2 screen_reference;
Flat(3, 2) float billboard_depth;
Flat(4, 0) ivec2 region_size;
Flat(4, 2) ivec2 region_first;  // (first_x, first_y)
Flat(5, 0) ivec3 atlas_place;
Flat(12, 0) vec4 depth_per_step;

const uint kIdEmpty = 0u;
const uint kIdOutline = 1u;
