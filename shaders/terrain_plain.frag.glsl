#version 330 core
uniform sampler2D shaded;

in vec2 place;
out vec4 colour;

void main() { colour = vec4(texture(shaded, place).rgb, 1.0); }
