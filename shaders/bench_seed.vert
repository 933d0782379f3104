// For `voxprite bench`: the proxy box of one entity, as the specification draws it.

#include "shared/bench_seed.glsl"

// Octant order, counter-clockwise seen from outside.
const int kBox[36] = int[](0, 4, 6, 0, 6, 2,  1, 3, 7, 1, 7, 5,   // -x +x
                           0, 1, 5, 0, 5, 4,  2, 6, 7, 2, 7, 3,   // -y +y
                           0, 2, 3, 0, 3, 1,  4, 5, 7, 4, 7, 6);  // -z +z

void main() {
    int octant = kBox[gl_VertexID];
    vec3 side = vec3(octant & 1, (octant >> 1) & 1, octant >> 2) * 2.0 - 1.0;
    gl_Position = clip_from_box * vec4(side * box_half, 1.0);
}
