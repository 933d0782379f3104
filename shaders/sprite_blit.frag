// Sprite buffer, last pass: the finished pixels from the atlas onto the screen, each where it
// belongs.

#include "shared/sprite_mapping.glsl"

// An image has no levels to choose from; a software rasteriser would choose for each pixel.
layout(binding = 0, r32ui) readonly uniform uimage2DArray sprite_image;

layout(location = 0) out uint colour;

#ifdef PER_PIXEL_DEPTH
#include "shared/sprite_depth.glsl"

layout(binding = 3) uniform usampler2DArray sprite_ids;

// Of models of up to 2^32 cells: ids of larger ones are no more unique.
ivec3 voxelOf(uint id) {
    uint index = id - 2u;
    uint row = index / svo_model_size.x;
    return ivec3(index % svo_model_size.x, row % svo_model_size.y, row / svo_model_size.y);
}

// Nothing but a voxel has a depth of its own.
float voxelDepth(ivec2 cell) {
    if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, region_size))) return 0.0;
    uint id = texelFetch(sprite_ids, atlas_place + ivec3(cell, 0), 0).r;
    return id > kIdOutline ? pixelDepth(cell, voxelOf(id)) : 0.0;
}

// An outline pixel stands where its nearest neighbour does.
float outlineDepth(ivec2 cell) {
    return max(max(voxelDepth(cell + ivec2(-1, 0)), voxelDepth(cell + ivec2(1, 0))),
               max(voxelDepth(cell + ivec2(0, -1)), voxelDepth(cell + ivec2(0, 1))));
}
#endif

void main() {
    ivec2 cell;
    if (!virtualPixel(gl_FragCoord.xy, cell)) discard;
    colour = imageLoad(sprite_image, atlas_place + ivec3(cell, 0)).r;
    if (colour == 0u) discard;
#ifdef PER_PIXEL_DEPTH
    bool outline = texelFetch(sprite_ids, atlas_place + ivec3(cell, 0), 0).r == kIdOutline;
    gl_FragDepth = outline ? outlineDepth(cell) : voxelDepth(cell);
#endif
}
