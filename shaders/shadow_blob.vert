// A soft ellipse on the ground under an entity.

layout(std140, binding = 5) uniform BlobBlock {
    vec4 blob_corners[4];  // clip space
    float blob_strength;
};

layout(location = 0) out vec2 from_centre;

const int kQuad[6] = int[](0, 1, 2, 2, 1, 3);

void main() {
    int corner = kQuad[gl_VertexID];
    gl_Position = blob_corners[corner];
    from_centre = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
}
