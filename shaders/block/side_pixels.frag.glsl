#version 330 core
#extension GL_ARB_texture_gather : enable
// The share that one of the block's sides has of a pixel, in one colour. Of a dry bed.
#include "block/block_samples.glsl"
#include "block/side_colour.glsl"

uniform int kind;

in vec3 world_point;
out vec4 colour;  // squares of display values times the share of the pixel, and that share

void main() {
    ivec4 there = seen_by_samples();
    vec4 of_side = vec4(equal(kinds_of(there), ivec4(kind)));
    float samples = dot(of_side, vec4(1.0));
    if (samples == 0.0) discard;
    float ground = dot(first_numbers(there), of_side) / samples;
    vec3 point = world_point;
    point.z = min(point.z, mix(height_range.x, height_range.y, ground));  // the middle may lie outside
    vec3 display = side_colour(point, vec2(ground));
    colour = 0.25 * samples * vec4(display * display, 1.0);
}
