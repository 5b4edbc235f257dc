#version 330 core
// The colour of endless ground, whose light is added a sample at a time: roots, for the sake of dark colours; and how far
// it is bare sand.
// Of quartz sand as measured, less saturated than the block's.
#define SAND_CREST vec3(0.610, 0.425, 0.245)
#define SAND_TROUGH vec3(0.480, 0.305, 0.160)
#include "colour.glsl"
#include "light.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"

in vec2 place;
out vec4 colour;

void main() { colour = vec4(sqrt(ground_albedo(place, bed_point(place))), bare_sand(place)); }
