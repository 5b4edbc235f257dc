#version 330 core
// The colour of endless ground, whose light is added a sample at a time: roots, for the sake of dark colours; and how far
// it is bare sand.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"

// Palette places up to which ground is bare floor, and from which it is sand alone; how far there is such ground at all.
uniform vec3 floor_values;

uniform float pales;             // 1: invented ground is grey
uniform sampler2D invented_map;  // how far ground is invented

uniform float own_texels;  // 1: the target has the maps' texels

in vec2 position;
out vec4 colour;

// How far wind has left coarse grains and crusts between dunes: low and level ground.
float floor_share(BedPoint point, float height, vec3 noise) {
    float level = 1.0 - smoothstep(0.05, 0.16, length(point.normal.xy) / max(point.normal.z, 0.1));
    float span = floor_values.y - floor_values.x;
    float value = height + span * (0.5 * noise.r + 0.3 * noise.g);
    return floor_values.z * natural * (1.0 - rock) * level * (1.0 - smoothstep(floor_values.x, floor_values.y, value));
}

// Gravel, greyer and darker than sand, and pale crusts of clay in patches.
vec3 floor_albedo(vec3 noise) {
    vec3 gravel = mix(vec3(luminance(sand_trough)), sand_trough, 0.76) * 0.92;
    vec3 crust = mix(vec3(luminance(sand_crest)), sand_crest, 0.66) * 0.93;
    float dried = smoothstep(0.15, 0.55, noise.b + 0.35 * noise.g - 0.1);
    return mix(gravel, crust, 0.7 * dried) * (1.0 + 0.06 * noise.g);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    BedPoint point = bed_point(own_texels > 0.5 ? texelFetch(lighting_map, texel, 0) : texture(lighting_map, position));
    float value = own_texels > 0.5 ? texelFetch(value_map, texel, 0).r : texture(value_map, position).r;
    vec3 noise = 2.0 * texture(noise_map, noise_position(position)).rgb - 1.0;
    float bare = bare_sand(position) * (1.0 - plain * rock);
    float between = bare * floor_share(point, value, noise);
    vec3 albedo = mix(ground_albedo(position, point, value), floor_albedo(noise), between);
    if (pales > 0.5) albedo = mix(albedo, vec3(mix(luminance(albedo), 0.45, 0.3)), 0.85 * texture(invented_map, position).r);
    colour = vec4(sqrt(albedo), bare * (1.0 - 0.85 * between));
}
