#version 330 core
in vec4 leaf_colour;
out vec4 colour;

void main() { colour = leaf_colour; }
