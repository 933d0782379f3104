// One sprite of one frame: where it stands on the screen and what it writes.
// sigma, voxel_size, anchor_to_center, ray_dir_local, camera_up_local and light_dir are what the
// integers of LatticeBlock and the palette were made from; they are here for whoever looks at a
// frame in a debugger.

layout(std140, binding = 2) uniform SpriteBlock {
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
};

const uint kIdEmpty = 0u;
const uint kIdOutline = 1u;
