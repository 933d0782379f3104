// A cluster in a scene: each face in one colour.

layout(location = 0) flat in vec3 face_colour;
layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(face_colour, 1.0);
}
