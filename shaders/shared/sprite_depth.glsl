// The depth of a pixel of its own: that of the centre of the voxel it shows.

// The vertex stage emits the nearest depth of the sprite; a fragment only moves away from it.
layout(depth_less) out float gl_FragDepth;

float voxelDepth(uint id, uvec3 model_size) {
    uint index = id - 2u;
    uint row = index / model_size.x;
    precise vec3 centre =
        vec3(uvec3(index % model_size.x, row % model_size.y, row / model_size.y)) + 0.5;
    precise float metres = dot(depth_row.xyz, centre) + depth_row.w;
    precise float depth = (depth_from_metres.x * metres + depth_from_metres.y) /
                          (depth_from_metres.z * metres + depth_from_metres.w);
    return min(depth, billboard_depth);
}
