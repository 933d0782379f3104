// The octree of a view that shows one model.

layout(std140, binding = 0) uniform OctreeBlock {
    uvec3 svo_model_size;
    uint svo_max_depth;
    ivec3 tree_from_voxel;
    uint node_offset;     // texels
    uint payload_offset;  // texels
};
