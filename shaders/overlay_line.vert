// A line as a quad that faces the camera: one instance a line.

layout(std140, binding = 7) uniform OverlayBlock {
    vec2 overlay_viewport_px;
    float overlay_opacity;
    float overlay_bias;  // relative, toward the eye, so that lines on a surface are seen whole
};

layout(location = 0) in vec4 clip_a;
layout(location = 1) in vec4 clip_b;
layout(location = 2) in vec4 line_colour;
layout(location = 3) in float width_px;

layout(location = 0) out vec4 colour_in;
layout(location = 1) out float from_axis_px;
layout(location = 2) flat out float half_width_px;

void main() {
    vec2 a = clip_a.xy / clip_a.w * 0.5 * overlay_viewport_px;
    vec2 b = clip_b.xy / clip_b.w * 0.5 * overlay_viewport_px;
    vec2 run = b - a;
    run = dot(run, run) > 1e-12 ? normalize(run) : vec2(1.0, 0.0);
    vec2 normal = vec2(-run.y, run.x);
    bool at_b = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    half_width_px = 0.5 * width_px;
    float reach = half_width_px + 1.0;
    from_axis_px = side * reach;
    colour_in = vec4(line_colour.rgb, line_colour.a * overlay_opacity);
    vec4 clip = at_b ? clip_b : clip_a;
    vec2 offset = normal * side * reach + (at_b ? run : -run) * 0.5 * half_width_px;
    // No perspective correction across the line: its width is one of the screen.
    gl_Position = vec4(clip.xy / clip.w + offset / (0.5 * overlay_viewport_px),
                       min(1.0, clip.z / clip.w * (1.0 + overlay_bias)), 1.0);
}
