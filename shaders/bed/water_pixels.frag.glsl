#version 330 core
// The colour of the surface of a block with water, a pixel at a time: shaded once where the samples of a pixel see one piece
// of it, and a sample at a time where they see several.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "bed/water.glsl"
#include "bed/water_ground.glsl"

uniform sampler2D seen;      // of block/seen_surface.frag.glsl
uniform vec2 height_span;    // of the surface: the lowest, and how much higher the highest
uniform float samples_along;        // samples along each side of a pixel
uniform vec2 sample_offset;  // of the first pixel's first sample
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;
uniform float linear_light;  // 1: the colours are radiances, not display values

out vec4 colour;

// Between samples: up to there, in cells of the maps or in widths of a pixel, one place stands for all.
const float near_cells = 1.25;
const float near_widths = 14.0;

// Of the grain's mipmaps, as in block/block_pixels.frag.glsl.
const float grain_bias = -0.4;

vec3 with_grain(vec4 ground, vec2 place, float level) {
    float speck = textureLod(grain, place * grain_scale, level).r - 0.5;
    float grainy = 1.0 + grain_strength * ground.a * speck;
    return ground.rgb * (linear_light > 0.5 ? grainy * grainy : grainy);
}

void main() {
    int along = int(samples_along);
    ivec2 first = ivec2(gl_FragCoord.xy) * along + ivec2(sample_offset);
    int samples = along * along;
    vec2 size = vec2(textureSize(lighting_map, 0));
    vec3 sum = vec3(0.0);
    vec2 least = vec2(2.0);
    vec2 most = vec2(-1.0);
    float count = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec4 there = texelFetch(seen, first + ivec2(i % along, i / along), 0);
        sum += there.w * there.xyz;
        count += there.w;
        least = min(least, there.xy + 2.0 * (1.0 - there.w));
        most = max(most, there.xy - 2.0 * (1.0 - there.w));
    }
    vec3 mean = sum / max(count, 1.0);
    vec2 apart = max(most - least, vec2(0.0));
    float cells = max(apart.x * size.x, apart.y * size.y);
    vec3 middle = vec3((mean.xy - 0.5) * extent, height_span.x + height_span.y * mean.z);
    float pixel = seen_width(middle);
    float span = length(apart * extent);
    bool whole = cells <= near_cells || span <= near_widths * pixel;
    // A loop is left, or never entered, where no place needs it; llvmpipe goes through both arms of an if.
    int steps = count == 0.0 ? 0 : whole ? 1 : samples;
    float spread = max(whole ? 0.6 * cells * samples_along / max(samples_along - 1.0, 1.0) : pixel * size.x / extent.x, 1.0);
    float level = log2(spread);
    float width = whole ? sqrt(pixel * max(pixel, 0.5 * span)) : pixel;
    vec2 grains = apart * grain_scale * vec2(textureSize(grain, 0));
    float grain_level = whole ? max(log2(max(max(grains.x, grains.y), 1.0)) + grain_bias, 0.0) : 1.0;
    vec3 squares = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        vec4 there = texelFetch(seen, first + ivec2(i % along, i / along), 0);
        if (whole) there = vec4(mean, 1.0);
        vec3 at = vec3((there.xy - 0.5) * extent, height_span.x + height_span.y * there.z);
        vec3 found = with_grain(water_ground(there.xy, at, width, level), there.xy, grain_level);
        squares += there.w * (linear_light > 0.5 ? found : found * found);
    }
    squares /= max(whole ? 1.0 : count, 1.0);
    colour = vec4(linear_light > 0.5 ? squares : sqrt(squares), 1.0);
}
