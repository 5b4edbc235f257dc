#version 330 core
// Colours one of the block's sides, and a little beyond it, pixel by pixel. Of a dry bed.
#include "block/side_colour.glsl"

uniform sampler2D ground_map;  // heights of the ground along each side, 0 … 1 over their range
uniform float ground_row;      // of this side

in vec3 world_point;
out vec4 colour;

void main() {
    vec2 across = world_point.xy / extent + 0.5;
    float along = abs(outward.x) > 0.5 ? across.y : across.x;
    float ground = texture(ground_map, vec2(along, ground_row)).r;
    vec3 point = world_point;
    point.z = min(point.z, mix(height_range.x, height_range.y, ground));  // a pixel's middle may lie outside
    colour = vec4(side_colour(point, vec2(ground)), 1.0);
}
