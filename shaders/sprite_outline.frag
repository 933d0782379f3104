// Sprite buffer, second pass: an empty pixel with an opaque cardinal neighbour becomes outline.
// Before it only what was hit is opaque.

#include "shared/sprite_draw.glsl"
#include "shared/sprite_varyings.glsl"

layout(binding = 2) uniform usampler2D sprite_colours;
layout(location = 0) out uint colour;
#ifdef SPRITE_IDS
layout(binding = 3) uniform usampler2D sprite_ids;
layout(location = 1) out uint id;
#endif

bool opaque(ivec2 cell) {
    if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, region_size))) return false;
    return texelFetch(sprite_colours, atlas_place.xy + cell, 0).r != 0u;
}

void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy) - atlas_place.xy;
    colour = texelFetch(sprite_colours, ivec2(gl_FragCoord.xy), 0).r;
#ifdef SPRITE_IDS
    id = texelFetch(sprite_ids, ivec2(gl_FragCoord.xy), 0).r;
#endif
    if (colour != 0u || outline_enabled == 0) return;
    if (opaque(cell + ivec2(-1, 0)) || opaque(cell + ivec2(1, 0)) || opaque(cell + ivec2(0, -1)) ||
        opaque(cell + ivec2(0, 1))) {
        colour = outline_colour;
#ifdef SPRITE_IDS
        id = kIdOutline;
#endif
    }
}
