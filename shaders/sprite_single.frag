// Single pass: every fragment casts the ray of its virtual pixel, and those of the four cardinal
// neighbours on a miss.

#include "shared/lattice.glsl"
#include "shared/sprite_draw.glsl"
#include "shared/sprite_mapping.glsl"
#include "shared/sprite_shade.glsl"

layout(binding = 1) uniform usampler2D palette_texture;  // lit; column = material, row = face

layout(location = 0) out uint colour;
layout(location = 1) out uint id;

#ifdef PER_PIXEL_DEPTH
#include "shared/sprite_depth.glsl"
#endif

const ivec2 kNeighbours[5] =
    ivec2[](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

void main() {
    ivec2 cell;
    if (!virtualPixel(gl_FragCoord.xy, cell)) discard;
    id = kIdEmpty;
#ifdef PER_PIXEL_DEPTH
    gl_FragDepth = 0.0;
#endif
    for (int k = 0; k < (outline_enabled != 0 ? 5 : 1); ++k) {
        ivec2 neighbour = cell + kNeighbours[k];
        // No ray outside the region meets the model.
        if (any(lessThan(neighbour, ivec2(0))) || any(greaterThanEqual(neighbour, region_size))) {
            continue;
        }
        LatticeHit hit = castLattice(neighbour + region_first);
        if (hit.material == 0u) continue;
        if (k == 0) {
            colour = texelFetch(palette_texture, ivec2(int(hit.material), shadedRow(hit)), 0).r;
            id = voxelId(hit);
        } else {
            colour = outline_colour;
            id = kIdOutline;
        }
#ifdef PER_PIXEL_DEPTH
        // An outline pixel stands where its nearest neighbour does.
        gl_FragDepth = max(gl_FragDepth, pixelDepth(neighbour, hit.voxel));
        if (id == kIdOutline) continue;
#endif
        break;
    }
    if (id == kIdEmpty) discard;
}
