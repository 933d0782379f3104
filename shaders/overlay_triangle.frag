layout(location = 0) in vec4 colour_in;
layout(location = 0) out vec4 colour;

void main() {
    colour = colour_in;
}
