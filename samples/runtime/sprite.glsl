// The sprite shader for engines: an octree of .svo cast on a lattice of integers, its outline, and
// the way to the screen. One file, five shaders; put one of these before it:
//
//     #version 330                           or 300 es, with precision highp for int, float and
//     #define SPRITE_VERTEX                  usampler2D
//
// SPRITE_VERTEX   a triangle over the whole viewport, from gl_VertexID 0 ... 2: for the two below.
// SPRITE_CAST     one ray a virtual pixel. Targets: 0 RGBA8UI colours, 1 R32UI ids. The viewport is
//                 (0, 0) to the sprite's size.
// SPRITE_OUTLINE  an empty pixel with an opaque neighbour becomes outline. Reads the two textures
//                 that SPRITE_CAST wrote, writes two more: the finished sprite. Keep it: it stays
//                 the same as long as model, frame, lattice and palette do.
// SPRITE_QUAD     the sprite's rectangle in the world: a strip of gl_VertexID 0 ... 3.
// SPRITE_BLIT     its pixels, each where it belongs.
//
// SPRITE_WIDE (and #version 400) casts in doubles, which hold whole numbers below 2^53: for views
// whose products outgrow 31 bits (lattice_is_narrow of voxprite_lattice.h says so). ES has none.
//
// Everything but SPRITE_QUAD and SPRITE_BLIT computes in whole numbers alone: every driver gives
// the same sprite, bit for bit. Rows of textures run upward, as OpenGL has them.

#if defined(SPRITE_VERTEX)

void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

#elif defined(SPRITE_CAST)

// Nodes, then payloads (two texels each, low word first), as they stand in the file; linear index i
// at (i % width, i / width).
uniform usampler2D octree;
uniform int octree_width;
uniform int node_offset;     // of the model's first node, in texels
uniform int payload_offset;  // of its first payload, in texels
uniform int max_depth;
uniform ivec3 model_size;
// The lattice view. `origin` is C from the corner model_size / 2, which keeps products small.
uniform int position_bits;
uniform ivec3 origin;
uniform ivec3 right;      // U
uniform ivec3 up;         // V
uniform ivec3 direction;  // D
uniform ivec2 first;
uniform usampler2D lit_palette;  // RGBA8UI: column = material, row = axis of the face

layout(location = 0) out uvec4 colour;
layout(location = 1) out uint id;

#ifdef SPRITE_WIDE
#define Number double
#else
#define Number int
#endif

// Each axis on which rays run downward is mirrored about the root cube, so that all run upward:
// cell c becomes c ^ (edge - 1), position x becomes edge - x.
ivec3 speed;   // |D|
ivec3 mirror;  // edge - 1 where mirrored
ivec3 box_low, box_high, centre;
Number start[3];  // of the ray, in steps from `centre`

// A moment on the ray: that at which it crosses a face of `axis`. Moments are ordered by the time
// t = way / speed[axis], and at the same time by axis.
struct Moment {
    Number way;
    int axis;
};

Number wayTo(int axis, int face) {
    return Number(face - centre[axis]) * Number(1 << position_bits) - start[axis];
}

// Has the ray crossed this face by then?
bool hasCrossed(int axis, int face, Moment now) {
    Number way = wayTo(axis, face);
    if (speed[axis] == 0) return way <= Number(0);
    Number mine = way * Number(speed[now.axis]);
    Number then = now.way * Number(speed[axis]);
    return mine < then || (mine == then && axis <= now.axis);
}

uint texel(int index) {
    return texelFetch(octree, ivec2(index % octree_width, index / octree_width), 0).r;
}

// The child of a node, a brick or a uniform leaf, whose children are like itself.
uint childOf(uint word, int octant) {
    if ((word & 0x80000000u) != 0u) {
        if (((word >> octant) & 1u) == 0u) return 0u;
        int child = int((word >> 8) & 0x7FFFFFu);
        for (uint before = word & ((1u << octant) - 1u); before != 0u; before &= before - 1u) {
            ++child;
        }
        return texel(node_offset + child);
    }
    if ((word & 0x40000000u) != 0u) {
        uint materials = texel(payload_offset + 2 * int(word & 0x3FFFFFFFu) + (octant >> 2));
        return (materials >> (8 * (octant & 3))) & 0xFFu;
    }
    return word;
}

void main() {
    int edge = 1 << max_depth;
    ivec2 pixel = first + ivec2(gl_FragCoord.xy);
    colour = uvec4(0u);
    id = 0u;
    speed = abs(direction);
    for (int a = 0; a < 3; ++a) {
        bool down = direction[a] < 0;
        mirror[a] = down ? edge - 1 : 0;
        box_low[a] = down ? edge - model_size[a] : 0;
        box_high[a] = box_low[a] + model_size[a];
        centre[a] = down ? edge - model_size[a] / 2 : model_size[a] / 2;
        Number along = Number(pixel.x) * Number(right[a]) + Number(pixel.y) * Number(up[a]);
#ifdef SPRITE_WIDE
        along = floor(along / 4096.0LF);
#else
        along >>= 12;
#endif
        start[a] = (Number(origin[a]) + along) * Number(down ? -1 : 1);
    }

    // The ray comes into the box with the last of its lower faces.
    Moment now = Moment(Number(0), -1);
    for (int a = 0; a < 3; ++a) {
        if (speed[a] == 0) continue;
        if (now.axis < 0 || !hasCrossed(a, box_low[a], now)) now = Moment(wayTo(a, box_low[a]), a);
    }
    if (now.axis < 0) return;
    for (int a = 0; a < 3; ++a) {
        if (!hasCrossed(a, box_low[a], now) || hasCrossed(a, box_high[a], now)) return;
    }

    for (int steps = 0; steps < 4 * edge; ++steps) {
        // Down to the cell: in the upper half of a node where the middle has been crossed. Faces
        // beyond the box need no look, which keeps products small.
        uint word = texel(node_offset);
        int level = max_depth;
        ivec3 low = ivec3(0);
        while (word != 0u && level > 0) {
            --level;
            int octant = 0;
            for (int a = 0; a < 3; ++a) {
                int middle = low[a] + (1 << level);
                bool upper = middle <= box_low[a] ||
                             (middle < box_high[a] && hasCrossed(a, middle, now));
                if (upper) low[a] = middle;
                octant |= (((low[a] ^ mirror[a]) >> level) & 1) << a;
            }
            word = childOf(word, octant);
        }
        if (word != 0u) {
            uvec3 voxel = uvec3(low ^ mirror);
            uvec3 size = uvec3(model_size);
            colour = texelFetch(lit_palette, ivec2(int(word), now.axis), 0);
            id = 2u + voxel.x + size.x * (voxel.y + size.y * voxel.z);
            if (id < 2u) id += 2u;  // 2^32 - 1 cells or more
            return;
        }
        // Out of the empty node by the first of its upper faces; beyond the box there is nothing.
        ivec3 ends = min(low + (1 << level), box_high);
        now.axis = -1;
        for (int a = 0; a < 3; ++a) {
            if (speed[a] == 0) continue;
            if (now.axis < 0 || wayTo(a, ends[a]) * Number(speed[now.axis]) <
                                    now.way * Number(speed[a])) {
                now = Moment(wayTo(a, ends[a]), a);
            }
        }
        if (ends[now.axis] == box_high[now.axis]) return;
    }
}

#elif defined(SPRITE_OUTLINE)

uniform usampler2D cast_colours;
uniform usampler2D cast_ids;
uniform uvec4 outline_colour;  // R, G, B, 255; all 0 for none

layout(location = 0) out uvec4 colour;
layout(location = 1) out uint id;

bool opaque(ivec2 at) {
    return all(greaterThanEqual(at, ivec2(0))) &&
           all(lessThan(at, textureSize(cast_ids, 0))) && texelFetch(cast_ids, at, 0).r != 0u;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    colour = texelFetch(cast_colours, at, 0);
    id = texelFetch(cast_ids, at, 0).r;
    if (id != 0u || outline_colour.a == 0u) return;
    if (opaque(at + ivec2(1, 0)) || opaque(at - ivec2(1, 0)) || opaque(at + ivec2(0, 1)) ||
        opaque(at - ivec2(0, 1))) {
        colour = outline_colour;
        id = 1u;
    }
}

#elif defined(SPRITE_QUAD)

uniform mat4 clip_from_pixel;  // of (x, y, 0, 1), virtual pixels from the sprite's left and bottom
uniform ivec2 sprite_size;
uniform float depth;  // of the model's centre in normalised device coordinates: one for all pixels

out vec2 pixel;

void main() {
    pixel = vec2(sprite_size) * vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = clip_from_pixel * vec4(pixel, 0.0, 1.0);
    gl_Position.z = depth * gl_Position.w;
}

#elif defined(SPRITE_BLIT)

uniform usampler2D sprite;

in vec2 pixel;
layout(location = 0) out vec4 colour;

void main() {
    ivec2 at = clamp(ivec2(floor(pixel)), ivec2(0), textureSize(sprite, 0) - 1);
    uvec4 word = texelFetch(sprite, at, 0);
    if (word.a == 0u) discard;
    colour = vec4(word) / 255.0;
}

#endif
