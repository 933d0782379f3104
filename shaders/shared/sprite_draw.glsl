// What all sprites of a draw share.
//
// Colours of sprites are words of RGBA8 all the way, red lowest: they are moved and never computed
// with.

layout(std140, binding = 2) uniform SpriteDraw {
    vec4 depth_from_metres;  // depth = (x * metres + y) / (z * metres + w)
    vec2 target_size;        // pixels
    uint outline_colour;  // RGBA8
    int outline_enabled;
    int first_sprite;
    int sprite_count;
    int occlusion_shown;  // FACE_SHADE: which rays faces cast
    int shadows_shown;
};
