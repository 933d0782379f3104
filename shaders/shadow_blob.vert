// Soft ellipses on the ground under the entities: an instance each.

struct Blob {
    vec4 corners[4];  // clip space
    vec4 strength;    // x
};

layout(std430, binding = 2) readonly buffer Blobs {
    Blob blobs[];
};

layout(location = 0) out vec2 from_centre;
layout(location = 1) flat out float strength;

const int kQuad[6] = int[](0, 1, 2, 2, 1, 3);

void main() {
    int corner = kQuad[gl_VertexID];
    gl_Position = blobs[gl_InstanceID].corners[corner];
    from_centre = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
    strength = blobs[gl_InstanceID].strength.x;
}
