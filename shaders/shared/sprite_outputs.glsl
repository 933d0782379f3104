// The vertex stage of sprites: what it hands on.

#define VERTEX_STAGE
#include "shared/sprite.glsl"
#include "shared/sprite_varyings.glsl"
#include "shared/ray_varyings.glsl"

void handOn(Sprite sprite) {
    pixel_from_screen_x = sprite.pixel_from_screen[0].xyz;
    pixel_from_screen_y = sprite.pixel_from_screen[1].xyz;
    pixel_from_screen_1 = sprite.pixel_from_screen[2].xyz;
    screen_reference = sprite.screen_reference;
    billboard_depth = sprite.billboard_depth;
    region_size = sprite.region_size;
    region_first = ivec2(sprite.first_x, sprite.first_y);
    atlas_place = sprite.atlas_place;
    depth_per_step = sprite.depth_per_step;
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
