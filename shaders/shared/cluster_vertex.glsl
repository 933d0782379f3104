// The corner of a cluster's quad, on its way to the screen.
//
// Quads meet in T-junctions: where the corner of one lies on the edge of another. A rasteriser
// rounds corners to parts of a pixel, and pixels between the two edges would show what is behind.
// So every quad is widened in its own plane, by just more than rounding can open.

// A pass over depth and one over colours meet in the same pixels.
invariant gl_Position;

struct ClusterCorner {
    vec3 from_eye_cell;  // tree space, from the instance's eye cell; not widened
    int face;            // outward: 0 +x, 1 +y, 2 +z, 3 -x, 4 -y, 5 -z
    uint material;
    uint level;
};

layout(location = 0) in uvec2 packed_vertex;
// Of the instance.
layout(location = 1) in mat4 clip_from_eye_cell;
layout(location = 5) in ivec3 eye_cell;   // tree space: what is near the eye has small coordinates
layout(location = 6) in uvec3 face_rows;  // of palette_texture, two in each word, +x first

layout(std140, binding = 9) uniform ClusterDrawBlock {
    vec2 half_frame_px;
    float widened_px;
    float level_tint;  // 0 ... 1
};

ClusterCorner clusterCorner() {
    ClusterCorner corner;
    ivec3 at = ivec3(packed_vertex.x & 0xFFFFu, packed_vertex.x >> 16, packed_vertex.y & 0xFFFFu);
    corner.from_eye_cell = vec3(at - eye_cell);
    corner.material = (packed_vertex.y >> 16) & 0xFFu;
    corner.face = int((packed_vertex.y >> 24) & 7u);
    corner.level = packed_vertex.y >> 27;
    return corner;
}

// Screen pixels that a step along a tree axis goes at a point.
vec2 pxPerVoxel(vec4 clip, vec4 clip_step) {
    return (clip_step.xy * clip.w - clip.xy * clip_step.w) / (clip.w * clip.w) * half_frame_px;
}

// How far the edge that runs along `edge` px moves out along `across` px: so many voxels that it
// moves by `widened_px`, as far as one pixel across does that.
float widening(vec2 across, vec2 edge) {
    float turned = abs(across.x * edge.y - across.y * edge.x);
    float wanted = widened_px * length(edge) / max(turned, 1e-30);
    return min(wanted, 1.0 / max(length(across), 1e-30));
}

vec4 clipPosition(ClusterCorner corner) {
    vec4 clip = clip_from_eye_cell * vec4(corner.from_eye_cell, 1.0);
    int axis = corner.face % 3;
    int u = (axis + 1) % 3;
    int v = (axis + 2) % 3;
    // Behind the eye nothing is seen, and pixels have no meaning.
    if (clip.w <= 0.0) return clip;
    vec2 u_px = pxPerVoxel(clip, clip_from_eye_cell[u]);
    vec2 v_px = pxPerVoxel(clip, clip_from_eye_cell[v]);
    int number = gl_VertexID & 3;
    vec3 wide = corner.from_eye_cell;
    wide[u] += (number == 1 || number == 2 ? 1.0 : -1.0) * widening(u_px, v_px);
    wide[v] += (number >= 2 ? 1.0 : -1.0) * widening(v_px, u_px);
    return clip_from_eye_cell * vec4(wide, 1.0);
}

// Levels from the finest on: calm, cool, warm.
vec3 levelColour(uint level) {
    const vec3 kColours[6] =
        vec3[](vec3(0.62, 0.65, 0.70), vec3(0.30, 0.58, 0.95), vec3(0.18, 0.75, 0.58),
               vec3(0.93, 0.78, 0.25), vec3(0.95, 0.50, 0.20), vec3(0.86, 0.26, 0.45));
    return kColours[min(level, 5u)];
}
