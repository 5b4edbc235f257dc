#version 330 core
// What samples see that see no ground.
out vec4 seen;

void main() { seen = vec4(0.0); }
