#version 330 core
// The display colour of the bed for a figure: the palette's colour, its light scaled by one number.
// No haze and no tone curve, so that the colour bar stays true.
#include "common/colour.glsl"
#include "bed/bed.glsl"
#include "bed/drape.glsl"

uniform sampler2D palette;
uniform float natural;
uniform vec3 to_sun;
uniform float shading;  // share of hill shading
uniform float clear;    // 1: as block diagrams are drawn

in vec2 position;
out vec4 colour;

// Level ground in a middle tone: slopes towards the sun are mixed with white, slopes away from it go far down, valleys
// are a little darker, and shadows but faint.
vec3 as_diagram(vec3 albedo, BedPoint point) {
    float facing = dot(point.normal, to_sun) - to_sun.z;
    facing *= mix(0.45, 1.0, point.sun);
    float open = mix(0.45, 1.0, point.sky);
    float dark = 1.0 - exp(3.4 * min(facing, 0.0));
    float bright = 1.0 - exp(-3.0 * max(facing, 0.0));
    vec3 shaded = albedo * mix(1.0, 0.05, dark) * open;
    return mix(shaded, vec3(0.96, 0.95, 0.92), mix(0.5, 0.9, natural) * bright * open);
}

void main() {
    BedPoint point = bed_point(position);
    float value = texture(value_map, position).r;
    vec3 albedo = linear_from_display(texture(palette, vec2(value * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb);
    vec3 plain = clear > 0.5 ? vec3(0.62, 0.52, 0.38) : vec3(0.82, 0.66, 0.45);
    albedo = marked(mix(albedo, plain, max(natural, texture(uncoloured_map, position).r)), position);
    Laid laid = drape_at(position, vec2(0.0));
    albedo = with_drape(albedo, laid);
    if (clear > 0.5) {
        vec3 displayed = display_from_linear(mix(albedo, as_diagram(albedo, point), shading));
        colour = vec4(as_it_is(displayed, laid, 1.0), 1.0 - laid.share);
        return;
    }
    float level = max(to_sun.z, 0.25);
    float lit = point.sun * max(dot(point.normal, to_sun), 0.0) / level;  // 1 on level ground
    float light = 0.30 + 0.32 * point.sky + 0.38 * min(lit, 1.6);
    light = min(light, 1.0);
    if (shading < 1.0) light = mix(1.0, light, shading);
    colour = vec4(as_it_is(display_from_linear(albedo * light), laid, 1.0), 1.0 - laid.share);
}
