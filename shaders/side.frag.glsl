#version 330 core
// The cut sides of the block: layers of sand, as in a dune's trench.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "bed.glsl"
#include "water_body.glsl"

uniform float base;
uniform float figure;  // 1: plain and grey
uniform float rock;

uniform sampler2D seen;      // grounds and surfaces, of side.vert.glsl
uniform vec2 height_range;

in vec3 world_point;
in vec2 outward;
out vec4 colour;

void main() {
    vec2 levels = mix(height_range.xx, height_range.yy, texelFetch(seen, ivec2(gl_FragCoord.xy), 0).xy);
    float ground = levels.x;
    float surface = levels.y;  // above the ground where water stands on it
    float along = world_point.x + world_point.y;
    float depth = ground - world_point.z;
    // Sets of cross-beds: thick layers that undulate, each filled with thin laminae of its own dip.
    float undulation = 0.55 * value_noise(vec2(along * 2.3, 4.5)) + 0.22 * value_noise(vec2(along * 7.1, 8.5));
    float sets = world_point.z * 52.0 + undulation;
    float set_number = floor(sets);
    float within = sets - set_number;
    ivec2 set_key = ivec2(int(set_number), 17);
    float dip = 0.35 * (hash(set_key) - 0.5);
    float laminae = (world_point.z + dip * along) * 260.0 + 0.7 * value_noise(vec2(along * 9.0, set_number));
    float lamina = value_noise(vec2(laminae, set_number * 7.0));
    float set_tone = mix(hash(set_key + ivec2(1, 5)), hash(set_key + ivec2(0, 5)), smoothstep(0.0, 0.10, 1.0 - within));
    float speck = value_noise(vec2(along, world_point.z) * 700.0);
    float tone = 0.26 + 0.34 * set_tone + 0.09 * lamina + 0.20 * (speck - 0.5) - 0.10 * smoothstep(0.90, 1.0, within);
    vec3 albedo = mix(vec3(0.54, 0.335, 0.175), vec3(0.74, 0.515, 0.30), clamp(tone, 0.0, 1.0));
    albedo = mix(albedo, mix(vec3(0.36, 0.215, 0.135), vec3(0.60, 0.43, 0.295), clamp(tone, 0.0, 1.0)), rock);
    vec3 normal = vec3(outward, 0.0);
    float sun = max(dot(normal, to_sun), 0.0);
    float above_ground = clamp((world_point.z - base) / 0.10, 0.0, 1.0);
    float open = 0.34 + 0.24 * above_ground;  // half the sky, less near the ground
    vec3 bounce = 0.42 * (sun_light * max(to_sun.z, 0.15) + 0.5 * sky_light) * vec3(0.78, 0.62, 0.44) *
                  (0.35 + 0.65 * max(0.5 + 0.5 * dot(normalize(to_sun.xy), outward), sun));
    float rim = 1.0 - 0.22 * exp(-depth * 160.0);  // the damp edge under the surface
    vec3 light = albedo * rim * (sun_light * 0.85 * sun + sky_light * open + bounce);
    if (world_point.z > ground && surface > ground) {  // water, cut through
        float up = (surface - world_point.z) / (surface - ground);
        light = mix(water_body_colour() * 1.6, vec3(0.10, 0.20, 0.22), 0.5 - 0.4 * up) * (sun_light * (0.35 + 0.5 * sun) + sky_light);
    }
    vec3 scenic = tone_curve(with_haze(light, world_point, -direction_to_eye(world_point)));
    float grey = 0.42 + 0.25 * sun + 0.05 * lamina;
    colour = vec4(display_from_linear(mix(scenic, vec3(grey) * vec3(1.0, 0.97, 0.93), figure)), 1.0);
}
