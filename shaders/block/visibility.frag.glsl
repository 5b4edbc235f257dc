#version 330 core
// What a sample sees, for the colours to be found once it is known.
in vec2 at_sample;
out vec4 visibility;

void main() { visibility = vec4(at_sample, 0.0, 0.0); }
