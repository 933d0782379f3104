// Sprite buffers, first pass: one ray a virtual pixel, a tile of pixels a group.

layout(local_size_x = 16, local_size_y = 4) in;  // as render/sprite_caster.cpp counts tiles

#define COMPUTE_STAGE
#include "shared/sprite_rays.glsl"
#include "shared/lattice.glsl"
#include "shared/sprite_shade.glsl"

struct CastTile {
    ivec2 corner;  // its first cell of the region
    int sprite;
    int unused;
};

layout(std430, binding = 1) readonly buffer CastTiles { CastTile tiles[]; };

layout(binding = 1) uniform usampler2D palette_texture;  // lit; column = material, row = face

layout(binding = 0, r32ui) uniform writeonly uimage2D colours;
#ifdef SPRITE_IDS
layout(binding = 1, r32ui) uniform writeonly uimage2D ids;
#endif

void main() {
    uint k = gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x;
    if (k >= uint(tiles.length())) return;
    int index = tiles[k].sprite;
    ivec2 cell = tiles[k].corner + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(cell, sprites[index].region_size))) return;
    takeRays(sprites[index]);
    LatticeHit hit = castLattice(ivec2(sprites[index].first_x, sprites[index].first_y) + cell);
    uint colour = 0u;
    uint id = 0u;
    if (hit.material != 0u) {
        colour = texelFetch(palette_texture, ivec2(int(hit.material), shadedRow(hit)), 0).r;
        id = voxelId(hit);
    }
    ivec2 texel = sprites[index].atlas_place.xy + cell;
    imageStore(colours, texel, uvec4(colour));
#ifdef SPRITE_IDS
    imageStore(ids, texel, uvec4(id));
#endif
}
