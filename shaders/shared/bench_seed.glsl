// One entity of the specification's renderer. The model's centre stands where the specification
// has the anchor, so that its pictures can be compared with ours.

layout(std140, binding = 0) uniform SeedBlock {
    mat4 clip_from_box;  // metres from the box's middle along its axes
    vec3 box_half;
    float voxel_size;
    vec3 ray_dir_local;
    float sigma;
    vec3 camera_up_local;
    float camera_distance;
    vec3 anchor_to_center;  // the model's centre, voxels
    float billboard_depth;
    uvec3 svo_model_size;
    uint svo_max_depth;
    vec2 center_ndc;
    vec2 proj_scale;
    vec2 viewport_size;
    uint node_offset;
    uint payload_offset;
};
