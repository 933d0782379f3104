layout(location = 0) in vec4 colour_in;
layout(location = 1) in float from_axis_px;
layout(location = 2) flat in float half_width_px;

layout(location = 0) out vec4 colour;

void main() {
    float coverage = clamp(half_width_px + 0.5 - abs(from_axis_px), 0.0, 1.0);
    colour = vec4(colour_in.rgb, colour_in.a * coverage);
}
