#version 330 core
// As block/side_strip.frag.glsl, of a bed with water.
#include "block/side_colour.glsl"

uniform sampler2D ground_map;  // along each side, heights of the ground and of the surface over it, 0 … 1 over their range
uniform float ground_row;      // of this side

in vec3 world_point;
out vec4 colour;

// A pixel sees ground and water where they meet; their light is mixed, of which display values are about the root.
void main() {
    vec2 across = world_point.xy / extent + 0.5;
    float along = abs(outward.x) > 0.5 ? across.y : across.x;
    vec2 heights = texture(ground_map, vec2(along, ground_row)).rg;
    vec2 levels = mix(height_range.xx, height_range.yy, heights);
    float pixel = max(fwidth(world_point.z), 1e-7);
    float top = min(world_point.z + 0.5 * pixel, levels.y);
    float share = clamp((top - levels.x) / max(top - world_point.z + 0.5 * pixel, 0.05 * pixel), 0.0, 1.0);
    vec3 ground = side_colour(vec3(world_point.xy, min(world_point.z, levels.x)), heights);
    vec3 water = side_colour(vec3(world_point.xy, clamp(world_point.z, mix(levels.x, levels.y, 0.02), levels.y)), heights);
    colour = vec4(sqrt(mix(ground * ground, water * water, share)), 1.0);
}
