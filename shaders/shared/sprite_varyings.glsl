// Of each sprite: where its pixels are on the screen and in the atlas.

#include "shared/flat_inputs.glsl"

layout(location = 0) Flat vec3 pixel_from_screen_x;
layout(location = 1) Flat vec3 pixel_from_screen_y;
layout(location = 2) Flat vec3 pixel_from_screen_1;
layout(location = 3) Flat vec2 screen_reference;
layout(location = 3, component = 2) Flat float billboard_depth;
layout(location = 4) Flat ivec2 region_size;
layout(location = 4, component = 2) Flat ivec2 region_first;  // (first_x, first_y)
layout(location = 5) Flat ivec3 atlas_place;
layout(location = 12) Flat vec4 depth_per_step;

const uint kIdEmpty = 0u;
const uint kIdOutline = 1u;
