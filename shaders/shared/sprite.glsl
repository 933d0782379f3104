// The sprites of a draw, one struct each, and what all of them share.
//
// sigma, voxel_size, camera_distance, anchor_to_center, ray_dir_local and camera_up_local are what
// the integers of the lattice and the palette were made from; they are here for whoever looks at a
// frame in a debugger.

struct Sprite {
    vec4 pixel_from_screen[3];  // of (x, y, 1), x and y from screen_reference; homogeneous
    vec2 screen_reference;
    ivec2 region_size;  // virtual pixels; cell (0, 0) of the region is pixel (first_x, first_y)
    ivec3 atlas_place;  // texel and page of cell (0, 0)
    int palette_row;    // the first of the sprite's in palette_texture
    // The lattice: C from the centre corner, U, V and D.
    ivec3 lattice_origin;
    int position_bits;
    ivec3 lattice_right;
    int first_x;
    ivec3 lattice_up;
    int first_y;
    ivec3 lattice_direction;
    uint svo_max_depth;
    uvec3 svo_model_size;
    uint node_offset;  // texels of svo_texture
    ivec3 tree_from_voxel;
    uint payload_offset;  // texels
    // Per-pixel depth: a point of the lattice, in steps from the centre corner, lies
    // dot(depth_per_step, (point, 1)) metres ahead of the eye.
    vec4 depth_per_step;
    vec3 ray_dir_local;
    float voxel_size;
    vec3 camera_up_local;
    float sigma;
    vec3 anchor_to_center;
    float billboard_depth;  // what the sprite writes; the nearest of it for per-pixel depth
    vec3 light_dir;  // toward the light, in the whole numbers of shadow rays
    float camera_distance;  // of the sprite plane, metres
};

layout(std430, binding = 0) readonly buffer Sprites {
    Sprite sprites[];
};

#include "shared/sprite_draw.glsl"
