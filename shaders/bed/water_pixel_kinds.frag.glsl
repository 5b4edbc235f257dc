#version 330 core
// Tells the pixels of a block with water apart, by depth: those that see dry ground, those that see water, and among both those
// whose samples see two places far apart, as at a brink before far ground. The colour is the place that a pixel is shaded
// for: of its nearest samples, and in alpha how far these lie apart.
#include "bed/bed.glsl"
#include "common/light.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "sky/sky.glsl"
#include "bed/water.glsl"
#include "bed/water_seen.glsl"

uniform float tinted;  // 0: no water is seen
uniform float dry_depth;
uniform float split_dry_depth;
uniform float wet_depth;
uniform float split_wet_depth;
uniform float nothing_depth;

out vec4 colour;

void main() {
    SeenSamples near = seen_samples(0.0);
    colour = vec4(near.mean, near.cells);
    Water water = water_at(near.mean.xy, level_over(near));
    bool dry = tinted < 0.5 || water.depth < least_share * closed_depth;
    float of_dry = near.share < 1.0 ? split_dry_depth : dry_depth;
    float of_wet = near.share < 1.0 ? split_wet_depth : wet_depth;
    gl_FragDepth = near.share == 0.0 ? nothing_depth : dry ? of_dry : of_wet;
}
