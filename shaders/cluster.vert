// A cluster's quads in the flat colours that a sprite gives their faces.

#include "shared/cluster_vertex.glsl"

// Column = material, a row for each light that falls on a face.
layout(binding = 1) uniform sampler2D palette_texture;

layout(location = 0) flat out vec3 face_colour;

void main() {
    ClusterCorner corner = clusterCorner();
    gl_Position = clipPosition(corner);
    uint row = (face_rows[corner.face >> 1] >> (16 * (corner.face & 1))) & 0xFFFFu;
    vec3 lit = texelFetch(palette_texture, ivec2(int(corner.material), int(row)), 0).rgb;
    float brightness = dot(lit, vec3(0.30, 0.59, 0.11));
    face_colour = mix(lit, levelColour(corner.level) * (0.35 + 0.65 * brightness), level_tint);
}
