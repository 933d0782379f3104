// What all sprites of a draw share.

layout(std140, binding = 2) uniform SpriteDraw {
    vec4 outline_colour;
    vec4 depth_from_metres;  // depth = (x * metres + y) / (z * metres + w)
    vec2 target_size;        // pixels
    int outline_enabled;
    int first_sprite;
    int sprite_count;
};
