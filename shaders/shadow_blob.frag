layout(location = 0) in vec2 from_centre;
layout(location = 1) flat in float strength;
layout(location = 0) out vec4 colour;

void main() {
    float inside = clamp(1.0 - dot(from_centre, from_centre), 0.0, 1.0);
    colour = vec4(0.02, 0.03, 0.06, strength * inside * inside * (3.0 - 2.0 * inside));
}
