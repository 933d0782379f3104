layout(std140, binding = 7) uniform OverlayBlock {
    vec2 overlay_viewport_px;
    float overlay_opacity;
    float overlay_bias;  // relative, toward the eye, so that what lies on a surface is seen whole
};

layout(location = 0) in vec4 clip_position;
layout(location = 1) in vec4 vertex_colour;

layout(location = 0) out vec4 colour_in;

void main() {
    colour_in = vec4(vertex_colour.rgb, vertex_colour.a * overlay_opacity);
    gl_Position = clip_position;
    gl_Position.z = min(gl_Position.w, gl_Position.z * (1.0 + overlay_bias));
}
