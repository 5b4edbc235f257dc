#version 330 core
#include "common/colour.glsl"

uniform vec3 given;
out vec4 colour;

void main() { colour = vec4(tone_curve(given), 1.0); }
