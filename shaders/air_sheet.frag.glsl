#version 330 core
uniform sampler2D sheet;

in vec4 painted;
out vec4 colour;

void main() { colour = texture(sheet, painted.xy); }
