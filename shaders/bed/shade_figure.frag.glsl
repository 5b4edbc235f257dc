#version 330 core
// The display colour of the bed for a figure: the palette's colour, its light scaled by one number.
// No haze and no tone curve, so that the colour bar stays true.
#include "common/colour.glsl"
#include "bed/bed.glsl"

uniform sampler2D palette;
uniform float natural;
uniform vec3 to_sun;
uniform float shading;  // share of hill shading

in vec2 place;
out vec4 colour;

void main() {
    BedPoint point = bed_point(place);
    float value = texture(value_map, place).r;
    vec3 albedo = linear_from_display(texture(palette, vec2(value * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb);
    albedo = marked(mix(albedo, vec3(0.82, 0.66, 0.45), max(natural, texture(uncoloured_map, place).r)), place);
    float level = max(to_sun.z, 0.25);
    float lit = point.sun * max(dot(point.normal, to_sun), 0.0) / level;  // 1 on level ground
    float light = 0.30 + 0.32 * point.sky + 0.38 * min(lit, 1.6);
    light = min(light, 1.0);
    if (shading < 1.0) light = mix(1.0, light, shading);
    colour = vec4(display_from_linear(albedo * light), 1.0);
}
