// A sprite's rays and the octree that they meet.

#include "shared/sprite.glsl"
#include "shared/ray_varyings.glsl"

void takeRays(Sprite sprite) {
    palette_row = sprite.palette_row;
    lattice_origin = sprite.lattice_origin;
    position_bits = sprite.position_bits;
    lattice_right = sprite.lattice_right;
    lattice_up = sprite.lattice_up;
    lattice_direction = sprite.lattice_direction;
    svo_model_size = sprite.svo_model_size;
    svo_max_depth = sprite.svo_max_depth;
    tree_from_voxel = sprite.tree_from_voxel;
    node_offset = sprite.node_offset;
    payload_offset = sprite.payload_offset;
#ifdef FACE_SHADE
    toward_light = ivec3(sprite.light_dir);
#endif
}
