#version 330 core
// Where the ground is that a sample sees, and over what length along the view, for its colour to be found once it is known;
// of far ground minus that length.
uniform float side;  // 1: near ground, −1: far ground

in vec3 at_sample;
out vec4 visibility;

void main() {
    vec2 view = normalize(at_sample.xy + 1e-9);
    visibility = vec4(at_sample, side * (abs(dot(dFdx(at_sample.xy), view)) + abs(dot(dFdy(at_sample.xy), view))));
}
