// The region of the screen that a sprite may touch: its own rectangle in the sprite plane, or the
// proxy box (of which the back faces are drawn, so that each screen pixel comes once).

#include "shared/sprite.glsl"

const int kQuad[6] = int[](0, 1, 2, 2, 1, 3);
// Octant order, counter-clockwise seen from outside.
const int kBox[36] = int[](0, 4, 6, 0, 6, 2,  1, 3, 7, 1, 7, 5,   // -x +x
                           0, 1, 5, 0, 5, 4,  2, 6, 7, 2, 7, 3,   // -y +y
                           0, 2, 3, 0, 3, 1,  4, 5, 7, 4, 7, 6);  // -z +z

void main() {
    gl_Position = corners[proxy_is_box != 0 ? kBox[gl_VertexID] : kQuad[gl_VertexID]];
}
