// What the fragments of a sprite need of it, handed on by the vertex stage: cheaper than fetching
// it from the buffer for each fragment.

#ifdef VERTEX_STAGE
#define Varying flat out
#else
#define Varying flat in
#endif

layout(location = 0) Varying vec3 pixel_from_screen_x;
layout(location = 1) Varying vec3 pixel_from_screen_y;
layout(location = 2) Varying vec3 pixel_from_screen_1;
layout(location = 3) Varying vec2 screen_reference;
layout(location = 3, component = 2) Varying float billboard_depth;
layout(location = 4) Varying ivec2 region_size;
layout(location = 4, component = 2) Varying ivec2 region_first;  // (first_x, first_y)
layout(location = 5) Varying ivec3 atlas_place;
layout(location = 5, component = 3) Varying int outline_enabled;
layout(location = 6) Varying vec4 outline_colour;
#ifdef PER_PIXEL_DEPTH
layout(location = 7) Varying vec4 depth_per_step;
layout(location = 8) Varying vec4 depth_from_metres;
layout(location = 9) Varying ivec3 ray_origin;  // the lattice's, from the centre corner
layout(location = 9, component = 3) Varying int ray_position_bits;
layout(location = 10) Varying ivec3 ray_right;
layout(location = 11) Varying ivec3 ray_up;
layout(location = 12) Varying ivec3 ray_direction;
layout(location = 13) Varying uvec3 model_size;
#endif

const uint kIdEmpty = 0u;
const uint kIdOutline = 1u;
