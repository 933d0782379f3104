// The view of one model's voxels: positions in voxels from the middle of the octree's root cube.

layout(std140, binding = 6) uniform VoxelViewBlock {
    vec4 box_corners[8];        // clip space, octant order
    vec4 voxel_ray_origin[3];   // per x, per y, constant: of a screen position from the middle
    vec4 voxel_ray_direction[3];  // for each metre ahead
    vec4 view_depth_from_t;     // depth = (x * t + y) / (z * t + w)
    vec4 face_light[3];         // by axis: x of the face toward +, y toward -
    vec4 background_top;
    vec4 background_bottom;
    vec4 grid_colour;           // alpha: its strength
    ivec3 view_box_low;         // tree coordinates
    float near_metres;
    ivec3 view_box_high;
    int edges_shown;
    vec2 half_viewport_px;
    vec2 grid_centre;           // x and y of the model's middle
    vec2 grid_corner;           // x and y of the model's minimum corner
    float grid_height;          // z of the model's bottom
    float grid_radius;          // voxels at which the grid has faded
    int grid_shown;
    int occlusion_shown;        // 1: in corners, 2: by short rays
    int view_leaf_level;        // of DEPTH_LIMIT: nodes of edge 2^this are the smallest cubes
    vec4 ghost_tint;            // alpha: that of a ghost's pixels; 0 for the model itself
    vec4 sun;                   // where it is; w: how much its light is missed in shadow, 0: none
    float ghost_nearer;         // what a ghost's depth is multiplied by
    float ghost_mixed;          // how much of its colour is the tint's
    float ghost_outline_px;     // width of the dashed line around it; 0: none
    float ghost_dash_px;
    ivec4 sprite_rays;          // a sprite's own light: xyz toward it where there are shadows, w: occlusion
};

vec3 voxelRayOrigin(vec2 screen) {
    vec2 p = screen - half_viewport_px;
    return voxel_ray_origin[0].xyz * p.x + voxel_ray_origin[1].xyz * p.y + voxel_ray_origin[2].xyz;
}

vec3 voxelRayDirection(vec2 screen) {
    vec2 p = screen - half_viewport_px;
    return voxel_ray_direction[0].xyz * p.x + voxel_ray_direction[1].xyz * p.y +
           voxel_ray_direction[2].xyz;
}
