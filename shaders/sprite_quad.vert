// The region of the screen that a sprite may touch (an instance is a sprite): its own rectangle in the sprite plane, or the
// proxy box (of which the back faces are drawn, so that each screen pixel comes once).

#define VERTEX_STAGE
#include "shared/sprite.glsl"
#include "shared/sprite_varyings.glsl"

const int kQuad[6] = int[](0, 1, 2, 2, 1, 3);
// Octant order, counter-clockwise seen from outside.
const int kBox[36] = int[](0, 4, 6, 0, 6, 2,  1, 3, 7, 1, 7, 5,   // -x +x
                           0, 1, 5, 0, 5, 4,  2, 6, 7, 2, 7, 3,   // -y +y
                           0, 2, 3, 0, 3, 1,  4, 5, 7, 4, 7, 6);  // -z +z

void main() {
    Sprite sprite = sprites[gl_InstanceID];
    pixel_from_screen_x = sprite.pixel_from_screen[0].xyz;
    pixel_from_screen_y = sprite.pixel_from_screen[1].xyz;
    pixel_from_screen_1 = sprite.pixel_from_screen[2].xyz;
    screen_reference = sprite.screen_reference;
    billboard_depth = sprite.billboard_depth;
    region_size = sprite.region_size;
    region_first = ivec2(sprite.first_x, sprite.first_y);
    atlas_place = sprite.atlas_place;
    outline_enabled = sprite.outline_enabled;
    outline_colour = sprite.outline_colour;
#ifdef PER_PIXEL_DEPTH
    depth_per_step = sprite.depth_per_step;
    depth_from_metres = sprite.depth_from_metres;
    ray_origin = sprite.lattice_origin;
    ray_position_bits = sprite.position_bits;
    ray_right = sprite.lattice_right;
    ray_up = sprite.lattice_up;
    ray_direction = sprite.lattice_direction;
    model_size = sprite.svo_model_size;
#endif
    int corner = sprite.proxy_is_box != 0 ? kBox[gl_VertexID] : kQuad[gl_VertexID];
    gl_Position = sprites[gl_InstanceID].corners[corner];
}
