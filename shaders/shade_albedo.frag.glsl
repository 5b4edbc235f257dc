#version 330 core
// The colour of endless ground, whose light is added a sample at a time: roots, for the sake of dark colours; and how far
// it is bare sand.
#include "colour.glsl"
#include "light.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"

in vec2 place;
out vec4 colour;

void main() { colour = vec4(sqrt(ground_albedo(place, bed_point(place))), bare_sand(place)); }
