#version 330 core
#include "common/light.glsl"

uniform vec3 way;
uniform float sun;
out vec4 colour;

void main() { colour = vec4(haze_before(way, sun), 1.0); }
