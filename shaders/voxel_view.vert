// The back faces of the model's box: every pixel whose ray may meet a voxel, once.

#include "shared/voxel_view.glsl"

const int kBox[36] = int[](0, 4, 6, 0, 6, 2,  1, 3, 7, 1, 7, 5,
                           0, 1, 5, 0, 5, 4,  2, 6, 7, 2, 7, 3,
                           0, 2, 3, 0, 3, 1,  4, 5, 7, 4, 7, 6);

void main() {
    gl_Position = box_corners[kBox[gl_VertexID]];
}
