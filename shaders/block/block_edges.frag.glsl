#version 330 core
#extension GL_ARB_texture_gather : enable
// The share that the surface has of the pixels whose samples see several things, or places far apart, sample by sample.
#include "block/block_samples.glsl"
#include "block/block_surface.glsl"

out vec4 colour;  // squares of display values times the share of the pixel, and that share

vec4 of_sample(int kind, vec2 place, float level) {
    vec3 display = surface_colour(place, textureLod(grain, place * grain_scale, level).r);
    return kind == surface_kind ? 0.25 * vec4(display * display, 1.0) : vec4(0.0);
}

void main() {
    ivec4 there = seen_by_samples();
    ivec4 kinds = kinds_of(there);
    vec4 east = first_numbers(there);
    vec4 north = second_numbers(there);
    // Of the grain, by how far apart two samples see it, on the nearer side where they see several things.
    vec2 texels = grain_scale * vec2(textureSize(grain, 0));
    vec2 south = texels * vec2(east.y - east.x, north.y - north.x);
    vec2 top = texels * vec2(east.w - east.z, north.w - north.z);
    vec2 left = texels * vec2(east.z - east.x, north.z - north.x);
    vec2 right = texels * vec2(east.w - east.y, north.w - north.y);
    float apart = max(min(dot(south, south), dot(top, top)), min(dot(left, left), dot(right, right)));
    float level = 0.5 * log2(max(apart, 1.0));
    colour = of_sample(kinds.x, vec2(east.x, north.x), level) + of_sample(kinds.y, vec2(east.y, north.y), level) +
             of_sample(kinds.z, vec2(east.z, north.z), level) + of_sample(kinds.w, vec2(east.w, north.w), level);
}
