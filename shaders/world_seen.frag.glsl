#version 330 core
// Where the ground is that a sample sees, for its colour to be found once it is known.
in vec3 at_sample;
out vec3 seen;

void main() { seen = at_sample; }
