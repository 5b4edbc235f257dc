#version 330 core
// Where the ground is that a sample sees, and over what length along the view, for its colour to be found once it is known.
in vec3 at_sample;
out vec4 seen;

void main() {
    vec2 view = normalize(at_sample.xy + 1e-9);
    seen = vec4(at_sample, abs(dot(dFdx(at_sample.xy), view)) + abs(dot(dFdy(at_sample.xy), view)));
}
