#version 330 core
#extension GL_ARB_texture_gather : enable
// Colours the pixels whose four samples see one piece of the block's surface, by one look at the shaded bed. The depth says
// which pixels are left: behind them lie those and what nothing covers.
#include "block/block_samples.glsl"
#include "block/block_surface.glsl"

uniform vec2 texels;  // of the shaded bed

out vec4 colour;  // squares of display values, and the share of the pixel

// Between samples, in texels: up to there a look halfway between them misses nothing.
const float near_enough = 1.25;

// Of the grain's mipmaps: ground lies aslant, and the finer axis should not be blurred as much as the other one.
const float grain_bias = -0.4;

void main() {
    ivec4 there = seen_by_samples();
    ivec4 kinds = kinds_of(there);
    if (kinds == ivec4(0)) discard;
    vec4 east = first_numbers(there);
    vec4 north = second_numbers(there);
    vec2 place = 0.25 * vec2(dot(east, vec4(1.0)), dot(north, vec4(1.0)));
    vec2 least = vec2(min(min(east.x, east.y), min(east.z, east.w)), min(min(north.x, north.y), min(north.z, north.w)));
    vec2 most = vec2(max(max(east.x, east.y), max(east.z, east.w)), max(max(north.x, north.y), max(north.z, north.w)));
    vec2 apart = (most - least) * texels;
    bool surface_only = kinds == ivec4(surface_kind);
    bool whole = surface_only && max(apart.x, apart.y) <= near_enough;
    bool no_side = all(lessThanEqual(kinds, ivec4(surface_kind)));
    bool no_surface = all(notEqual(kinds, ivec4(surface_kind)));
    vec3 display = surface_colour(place, texture(grain, place * grain_scale, grain_bias).r);
    colour = whole ? vec4(display * display, 1.0) : vec4(0.0);
    gl_FragDepth = whole ? 0.875 : no_surface ? 0.625 : no_side ? 0.125 : 0.375;
}
