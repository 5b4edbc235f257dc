#version 330 core
// What a sample sees, for the colours to be found once it is known.
in vec2 at_sample;
out vec2 seen;

void main() { seen = at_sample; }
