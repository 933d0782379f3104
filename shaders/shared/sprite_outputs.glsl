// The vertex stage of sprites: what it hands on.

#define VERTEX_STAGE
#include "shared/sprite_rays.glsl"
#include "shared/sprite_varyings.glsl"

// Sprites are drawn in groups, a group an instance: four vertices make a poor instance.
const int kGroupSize = 32;

// Which sprite a vertex belongs to, each having so many; -1 beyond the last.
int spriteOfVertex(int vertices_each) {
    int number = gl_InstanceID * kGroupSize + gl_VertexID / vertices_each;
    return number < sprite_count ? first_sprite + number : -1;
}

const vec4 kNowhere = vec4(2.0, 2.0, 0.0, 1.0);

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
    takeRays(sprite);
}
