// Sprite buffer, first pass: one ray a virtual pixel.

#include "shared/lattice.glsl"
#include "shared/sprite_varyings.glsl"

layout(binding = 1) uniform usampler2D palette_texture;  // lit; column = material, row = face axis

layout(location = 0) out uint colour;
layout(location = 1) out uint id;

void main() {
    LatticeHit hit = castLattice(region_first + ivec2(gl_FragCoord.xy) - atlas_place.xy);
    if (hit.material == 0u) {
        colour = 0u;
        id = 0u;
        return;
    }
    ivec2 shade = ivec2(int(hit.material), palette_row + hit.face_axis);
    colour = texelFetch(palette_texture, shade, 0).r;
    id = voxelId(hit);
}
