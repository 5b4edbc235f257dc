#version 330 core
// The cut sides of the block: layers of sand, as in a dune's trench.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "bed.glsl"

uniform float base;
uniform float figure;  // 1: plain and grey
uniform float rock;

in vec3 world_point;
in vec2 outward;
in float surface;
out vec4 colour;

void main() {
    float along = world_point.x + world_point.y * 1.37;
    float depth = surface - world_point.z;
    // Layers follow the surface loosely near it and lie flat deeper down.
    float layer = world_point.z * 1.0 + 0.006 * value_noise(vec2(along * 3.0, 1.5)) +
                  0.35 * surface * exp(-depth * 22.0) * 0.0;
    float wide = value_noise(vec2(layer * 95.0, along * 1.1));
    float thin = value_noise(vec2(layer * 330.0, along * 2.3 + 9.0));
    float tone = 0.5 + 0.30 * wide + 0.16 * thin;
    vec3 albedo = mix(vec3(0.44, 0.245, 0.115), vec3(0.70, 0.46, 0.245), clamp(tone, 0.0, 1.0));
    albedo = mix(albedo, mix(vec3(0.24, 0.18, 0.14), vec3(0.42, 0.34, 0.26), clamp(tone, 0.0, 1.0)), rock);
    vec3 normal = vec3(outward, 0.0);
    float sun = max(dot(normal, to_sun), 0.0);
    float above_ground = clamp((world_point.z - base) / 0.10, 0.0, 1.0);
    float open = 0.28 + 0.24 * above_ground;  // half the sky, less near the ground
    vec3 bounce = 0.30 * (sun_light * max(to_sun.z, 0.15) + 0.5 * sky_light) * vec3(0.78, 0.62, 0.44) *
                  (0.35 + 0.65 * max(0.5 + 0.5 * dot(normalize(to_sun.xy), outward), sun));
    float rim = 1.0 - 0.22 * exp(-depth * 160.0);  // the damp edge under the surface
    vec3 light = albedo * rim * (sun_light * 0.85 * sun + sky_light * open + bounce);
    vec3 scenic = tone_curve(with_haze(light, world_point, -direction_to_eye(world_point)));
    float grey = 0.42 + 0.25 * sun + 0.05 * thin;
    colour = vec4(display_from_linear(mix(scenic, vec3(grey) * vec3(1.0, 0.97, 0.93), figure)), 1.0);
}
