#version 330 core
// Tells the pixels of a block with water apart, by depth: those that see ground on which no water is closed, or a film of it
// at most, or any, and those whose samples see two places far apart. The colour is the place that a pixel is shaded for, and in alpha
// how far its samples lie apart.
#include "bed/bed.glsl"
#include "common/light.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "sky/sky.glsl"
#include "bed/water.glsl"
#include "water/water_visibility.glsl"

uniform float tinted;  // 0: no water is seen
uniform float dry_depth;
uniform float thin_depth;
uniform float deep_depth;
uniform float split_depth;
uniform float nothing_depth;

out vec4 colour;

void main() {
    PixelSamples all = pixel_samples();
    colour = vec4(all.mean, all.cells);
    float level = level_over(all);
    float share = tinted < 0.5 ? 0.0 : depth_at(all.mean.xy, level) / closed_depth;
    if (tinted > 0.5 && share < dry_share && cover_at(all.mean.xy, level) > 0.0) share = dry_share;
    float of_water = share < dry_share ? dry_depth : share < thin_share ? thin_depth : deep_depth;
    gl_FragDepth = all.share == 0.0 ? nothing_depth : are_far_apart(all) ? split_depth : of_water;
}
