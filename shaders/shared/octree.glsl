// The baked octree in a texture: nodes, then payloads, linear index i at (i % width, i / width).
// The words are those of core/svo/octree.h. All cells here are tree coordinates, inside the root.
// Who includes this declares, as uniforms or as inputs: uint svo_max_depth, and node_offset and
// payload_offset in texels (a payload takes two, low word first).

layout(binding = 0) uniform usampler2D svo_texture;

// With LEAF_LEVEL defined, nodes of edge 2^LEAF_LEVEL are leaves, solid ones if they hold anything.
int leafLevel() {
#ifdef LEAF_LEVEL
    return LEAF_LEVEL;
#else
    return 0;
#endif
}

const uint kWidthBits = 12u;  // the texture is 4096 texels wide
const uint kInternal = 0x80000000u;
const uint kBrick = 0x40000000u;

bool hasChildren(uint word, int shift) {
#ifdef LEAF_LEVEL
    if (shift <= LEAF_LEVEL) return false;
#endif
    return (word & kInternal) != 0u;
}

uint svoTexel(uint index) {
    return texelFetch(svo_texture,
                      ivec2(int(index & ((1u << kWidthBits) - 1u)), int(index >> kWidthBits)), 0).r;
}

// The material of a node taken for a leaf: that of its first solid voxel, octant by octant in their
// order (firstMaterial of core/trace/octree_walk.h).
uint firstMaterial(uint word) {
    while ((word & kInternal) != 0u) word = svoTexel(node_offset + ((word & 0x7FFFFF00u) >> 8u));
    if ((word & kBrick) == 0u) return word;
    uint payload = payload_offset + 2u * (word & 0x3FFFFFFFu);
    uint materials = svoTexel(payload);
    if (materials == 0u) materials = svoTexel(payload + 1u);
    return (materials >> (uint(findLSB(materials)) & 24u)) & 0xFFu;
}

// A cube of one material: the cell itself in a brick, or the largest node known to be of one kind.
// Its edge is 2^shift cells.
struct Region {
    uint material;  // 0 is empty
    int shift;
};

// Remembers the words on the way down, so that the next look-up nearby starts where the paths part.
struct Cursor {
    ivec3 cell;
    int shift;  // of the deepest word remembered
};
uint path_words[17];  // by shift

void startAtRoot(out Cursor cursor) {
    cursor.cell = ivec3(0);
    cursor.shift = int(svo_max_depth);
    path_words[cursor.shift] = svoTexel(node_offset);
}

Region regionAt(ivec3 cell, inout Cursor cursor) {
    ivec3 changed = cell ^ cursor.cell;
    int shift = max(cursor.shift, findMSB(changed.x | changed.y | changed.z) + 1);
    uint word = path_words[shift];
    Region region = Region(0u, shift);
    while (hasChildren(word, region.shift)) {
        --region.shift;
        ivec3 bits = (cell >> region.shift) & 1;
        uint octant = uint(bits.x | (bits.y << 1) | (bits.z << 2));
        uint children = word & 0xFFu;
        if (((children >> octant) & 1u) == 0u) break;
        uint child = ((word & 0x7FFFFF00u) >> 8u) +
                     uint(bitCount(children & ((1u << octant) - 1u)));
        word = svoTexel(node_offset + child);
        shift = region.shift;
        path_words[shift] = word;
    }
    cursor.cell = cell;
    cursor.shift = shift;
    if (region.shift < shift) return region;  // there is no such child
#ifdef LEAF_LEVEL
    if (region.shift <= LEAF_LEVEL && word > 0xFFu) {
        region.material = 1u;  // of several: castQuantised asks for the first
        return region;
    }
#endif
    if ((word & kBrick) != 0u) {
        ivec3 bits = cell & 1;
        uint payload = payload_offset + 2u * (word & 0x3FFFFFFFu) + uint(bits.z);
        region.material = (svoTexel(payload) >> uint(8 * (bits.x | (bits.y << 1)))) & 0xFFu;
        region.shift = 0;
        return region;
    }
    region.material = word & 0xFFu;
    return region;
}
