// The sprites of one draw: where each stands on the screen and what it writes.
// sigma, voxel_size, anchor_to_center, ray_dir_local, camera_up_local and light_dir are what the
// integers of the lattice and the palette were made from; they are here for whoever looks at a
// frame in a debugger.

struct Sprite {
    vec4 corners[8];            // clip space; a quad's four, or a box's eight in octant order
    vec4 pixel_from_screen[3];  // of (x, y, 1), x and y from screen_reference; homogeneous
    vec2 screen_reference;
    ivec2 region_size;  // virtual pixels; pixel (0, 0) of the region is (first_x, first_y)
    vec4 outline_colour;
    int outline_enabled;
    int proxy_is_box;
    float billboard_depth;  // what the sprite writes; the nearest of it for per-pixel depth
    float camera_distance;  // of the sprite plane, metres
    // Per-pixel depth: a point of the lattice, in steps from the centre corner, lies
    // dot(depth_per_step, (point, 1)) metres ahead of the eye, at the depth
    // (x * metres + y) / (z * metres + w).
    vec4 depth_per_step;
    vec4 depth_from_metres;
    vec3 ray_dir_local;
    float voxel_size;
    vec3 camera_up_local;
    float sigma;
    vec3 anchor_to_center;
    vec3 light_dir;
    // The lattice as in LatticeBlock, but D with its signs.
    ivec3 lattice_origin;
    int position_bits;
    ivec3 lattice_right;
    int first_x;
    ivec3 lattice_up;
    int first_y;
    ivec3 lattice_direction;
    uvec3 svo_model_size;
    ivec3 atlas_place;  // texel and page of pixel (0, 0) of the region
};

layout(std430, binding = 2) readonly buffer Sprites {
    Sprite sprites[];
};
