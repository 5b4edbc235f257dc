#version 330 core
// The share that the surface has of the pixels whose samples see several things, sample by sample.
#include "block_samples.glsl"
#include "block_surface.glsl"

out vec4 colour;  // squares of display values times the share of the pixel, and that share

vec4 of_sample(int kind, vec2 place) {
    vec3 display = surface_colour(place, textureLod(grain, place * grain_scale, 0.0).r);
    return kind == surface_kind ? 0.25 * vec4(display * display, 1.0) : vec4(0.0);
}

void main() {
    ivec4 there = seen_by_samples();
    ivec4 kinds = kinds_of(there);
    vec4 east = first_numbers(there);
    vec4 north = second_numbers(there);
    colour = of_sample(kinds.x, vec2(east.x, north.x)) + of_sample(kinds.y, vec2(east.y, north.y)) +
             of_sample(kinds.z, vec2(east.z, north.z)) + of_sample(kinds.w, vec2(east.w, north.w));
}
