// Sprite buffer, last pass: the finished pixels onto the screen, each where it belongs.

#include "shared/sprite_mapping.glsl"

layout(binding = 2) uniform sampler2D sprite_colours;
layout(binding = 3) uniform usampler2D sprite_ids;

layout(location = 0) out vec4 colour;

#ifdef PER_PIXEL_DEPTH
#include "shared/octree.glsl"
#include "shared/sprite_depth.glsl"

uint idAt(ivec2 cell) {
    if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, region_size))) return kIdEmpty;
    return texelFetch(sprite_ids, cell, 0).r;
}

float depthOf(uint id) {
    return id > kIdOutline ? voxelDepth(id, svo_model_size) : 0.0;
}

// An outline pixel stands where its nearest neighbour does.
float pixelDepth(ivec2 cell, uint id) {
    if (id > kIdOutline) return depthOf(id);
    return max(max(depthOf(idAt(cell + ivec2(-1, 0))), depthOf(idAt(cell + ivec2(1, 0)))),
               max(depthOf(idAt(cell + ivec2(0, -1))), depthOf(idAt(cell + ivec2(0, 1)))));
}
#endif

void main() {
    ivec2 cell;
    if (!virtualPixel(gl_FragCoord.xy, cell)) discard;
    uint id = texelFetch(sprite_ids, cell, 0).r;
    if (id == kIdEmpty) discard;
    colour = texelFetch(sprite_colours, cell, 0);
#ifdef PER_PIXEL_DEPTH
    gl_FragDepth = pixelDepth(cell, id);
#endif
}
