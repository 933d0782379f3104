// Single pass: every fragment casts the ray of its virtual pixel, and those of the four cardinal
// neighbours on a miss.

#include "shared/lattice.glsl"
#include "shared/sprite_mapping.glsl"

layout(binding = 1) uniform sampler2D palette_texture;  // lit; column = material, row = face axis

layout(location = 0) out vec4 colour;
layout(location = 1) out uint id;

#ifdef PER_PIXEL_DEPTH
#include "shared/sprite_depth.glsl"
#endif

const ivec2 kNeighbours[5] =
    ivec2[](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

void main() {
    ivec2 cell;
    if (!virtualPixel(gl_FragCoord.xy, cell)) discard;
    cell += ivec2(first_x, first_y);
    id = kIdEmpty;
    for (int k = 0; k < (outline_enabled != 0 ? 5 : 1); ++k) {
        LatticeHit hit = castLattice(cell + kNeighbours[k]);
        if (hit.material == 0u) continue;
        if (k == 0) {
            colour = texelFetch(palette_texture, ivec2(int(hit.material), hit.face_axis), 0);
            id = voxelId(hit);
        } else {
            colour = outline_colour;
            id = kIdOutline;
        }
#ifdef PER_PIXEL_DEPTH
        float depth = voxelDepth(voxelId(hit), svo_model_size);
        gl_FragDepth = id == kIdOutline && k > 1 ? max(gl_FragDepth, depth) : depth;
        if (id == kIdOutline) continue;  // an outline pixel stands where its nearest neighbour does
#endif
        break;
    }
    if (id == kIdEmpty) discard;
}
