// Sprite buffer, first pass: one ray a virtual pixel.

#include "shared/lattice.glsl"
#include "shared/sprite_draw.glsl"
#include "shared/sprite_shade.glsl"
#include "shared/sprite_varyings.glsl"

layout(binding = 1) uniform usampler2D palette_texture;  // lit; column = material, row = face

layout(location = 0) out uint colour;
layout(location = 1) out uint id;

void main() {
    LatticeHit hit = castLattice(region_first + ivec2(gl_FragCoord.xy) - atlas_place.xy);
    if (hit.material == 0u) {
        colour = 0u;
        id = 0u;
        return;
    }
    colour = texelFetch(palette_texture, ivec2(int(hit.material), shadedRow(hit)), 0).r;
    id = voxelId(hit);
}
