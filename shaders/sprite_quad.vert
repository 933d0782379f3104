// The region of the screen that a sprite may touch: its own rectangle in the sprite plane, or the
// proxy box (of which the back faces are drawn, so that each screen pixel comes once).

#include "shared/sprite_outputs.glsl"

// Clip space; a quad's four, or a box's eight in octant order.
layout(std430, binding = 1) readonly buffer SpriteCorners {
    vec4 sprite_corners[];
};

#ifdef PROXY_BOX
const int kCorners = 8;
#else
const int kCorners = 4;
#endif

void main() {
    int index = spriteOfVertex(kCorners);
    if (index < 0) {
        gl_Position = kNowhere;
        return;
    }
    handOn(sprites[index]);
    gl_Position = sprite_corners[index * kCorners + gl_VertexID % kCorners];
}
