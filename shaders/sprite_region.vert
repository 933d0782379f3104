// The place of a sprite in the atlas, one fragment a virtual pixel.

#include "shared/sprite_outputs.glsl"

void main() {
    int index = spriteOfVertex(4);
    if (index < 0) {
        gl_Position = kNowhere;
        return;
    }
    handOn(sprites[index]);
    ivec2 corner = ivec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
    vec2 texel = vec2(sprites[index].atlas_place.xy + sprites[index].region_size * corner);
    gl_Position = vec4(2.0 * texel / target_size - 1.0, 0.0, 1.0);
}
