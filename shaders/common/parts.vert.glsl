#version 330 core
// Parts of a target, by the corners of their triangles.
in vec2 corner;  // −1 … 1 over the target

void main() { gl_Position = vec4(corner, 0.0, 1.0); }
