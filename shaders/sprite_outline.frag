// Sprite buffer, second pass: an empty pixel with an opaque cardinal neighbour becomes outline.

#include "shared/sprite_varyings.glsl"

layout(binding = 2) uniform sampler2D sprite_colours;
layout(binding = 3) uniform usampler2D sprite_ids;

layout(location = 0) out vec4 colour;
layout(location = 1) out uint id;

bool opaque(ivec2 cell) {
    if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, region_size))) return false;
    return texelFetch(sprite_ids, cell, 0).r > kIdOutline;
}

void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy) - atlas_place.xy;
    id = texelFetch(sprite_ids, cell, 0).r;
    colour = texelFetch(sprite_colours, cell, 0);
    if (id != kIdEmpty || outline_enabled == 0) return;
    if (opaque(cell + ivec2(-1, 0)) || opaque(cell + ivec2(1, 0)) || opaque(cell + ivec2(0, -1)) ||
        opaque(cell + ivec2(0, 1))) {
        id = kIdOutline;
        colour = outline_colour;
    }
}
