#version 330 core
// The colour of the surface of a block with water, once a pixel: of the place that water/water_pixel_kinds.frag.glsl found, or of
// both where its samples see two.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "bed/drape.glsl"
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "bed/water.glsl"
uniform float under_water;  // what is known of it; see bed/water.glsl
#include "bed/water_ground.glsl"
#include "water/water_visibility.glsl"

uniform float split;       // 1: of pixels whose samples see two places
uniform sampler2D positions;  // of water/water_pixel_kinds.frag.glsl
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;
uniform float linear_light;  // 1: the colours are radiances, not display values

out vec4 colour;

// Of the grain's mipmaps: ground lies aslant, and the finer axis should not blur.
const float grain_bias = -0.4;

vec3 with_grain(vec4 ground, vec2 position, float level) {
    float speck = textureLod(grain, position * grain_scale, level).r - 0.5;
    float grainy = 1.0 + grain_strength * ground.a * speck;
    return ground.rgb * (linear_light > 0.5 ? grainy * grainy : grainy);
}

vec3 shaded(PixelSamples position) {
    vec3 at = point_at(position.mean);
    vec2 size = vec2(textureSize(lighting_map, 0));
    float pixel = pixel_width_at(at);
    float width = sqrt(pixel * max(pixel, 0.5 * position.cells * extent.x / size.x));
    vec2 grains = position.cells / size * grain_scale * vec2(textureSize(grain, 0));
    float grain_level = max(log2(max(max(grains.x, grains.y), 1.0)) + grain_bias, 0.0);
    return with_grain(water_ground(position.mean.xy, at, width, level_over(position)), position.mean.xy, grain_level);
}

void main() {
    if (split < 0.5) {
        vec4 position = texelFetch(positions, ivec2(gl_FragCoord.xy), 0);
        colour = vec4(shaded(PixelSamples(position.xyz, position.w, 1.0)), 1.0);
        return;
    }
    PixelSamples all = pixel_samples();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        PixelSamples half_of = half_of_samples(all, float(i));
        vec3 light = shaded(half_of);
        // Light is mixed, of which display values are about the root.
        sum += half_of.share * (linear_light > 0.5 ? light : light * light);
    }
    colour = vec4(linear_light > 0.5 ? sum : sqrt(sum), 1.0);
}
