#version 330 core
// What surrounds the block: a pale plain under it, darkened where the block stands and shades it,
// fading into the haze, and the sky above. Written at the picture's own resolution with one step of
// dither, so that its slow gradients do not band.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"

uniform vec3 ray_origin;
uniform vec3 ray_right;    // origin or direction moves by these over the picture
uniform vec3 ray_up;
uniform vec3 ray_forward;
uniform float parallel;
uniform float base;        // height of the plain
uniform float height;      // of the block's surface above it
uniform vec2 extent;
uniform vec2 picture_pixels;
uniform vec2 tile_pixel;   // first pixel of this tile

in vec2 place;
out vec4 colour;

// Distance to the shadow's outline: the block's outline swept along the shadow's direction.
float distance_to_shadow(vec2 p, vec2 reach) {
    vec2 half_extent = 0.5 * extent;
    vec2 middle = 0.5 * reach;
    vec2 grown = half_extent + abs(middle);
    vec2 q = abs(p - middle) - grown;
    vec2 across = vec2(-reach.y, reach.x) / max(length(reach), 1e-6);
    float band = abs(dot(p, across)) - dot(half_extent, abs(across));
    float box = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
    return max(box, band);
}

float distance_to_block(vec2 p) {
    vec2 q = abs(p) - 0.5 * extent;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

vec3 plain(vec3 point, vec3 view) {
    vec2 reach = -to_sun.xy / max(to_sun.z, 0.08) * height;
    float away = distance_to_block(point.xy);
    float soft = 0.010 + 0.16 * min(max(away, 0.0), length(reach));
    float lit = smoothstep(-soft, soft, distance_to_shadow(point.xy, reach));
    float open = 1.0 - 0.55 * exp(-max(away, 0.0) / (0.55 * height + 1e-4)) - 0.12 * exp(-max(away, 0.0) / 0.35);
    vec3 albedo = vec3(0.66, 0.50, 0.335) * (1.0 + 0.03 * value_noise(point.xy * 2.1));
    vec3 light = albedo * (sun_light * max(to_sun.z, 0.0) * lit * (0.55 + 0.45 * open) + sky_light * open);
    return with_haze(light, point, view);
}

vec3 sky(vec3 view) {
    vec3 horizon = haze_towards(view);
    float height_of_view = clamp(view.z, 0.0, 1.0);
    vec3 colour_there = mix(horizon, zenith_colour, 1.0 - exp(-2.6 * height_of_view));
    float near_sun = max(dot(view, to_sun), 0.0);
    near_sun *= near_sun; near_sun *= near_sun; near_sun *= near_sun;
    return colour_there + glow_colour * 0.35 * near_sun;
}

void main() {
    vec2 at = (gl_FragCoord.xy + tile_pixel) / picture_pixels;
    vec2 across = vec2(2.0, -2.0) * at + vec2(-1.0, 1.0);  // rows run downward
    vec3 offset = across.x * ray_right + across.y * ray_up;
    vec3 origin = ray_origin + parallel * offset;
    vec3 view = normalize(ray_forward + (1.0 - parallel) * offset);
    vec3 light;
    if (view.z < -1e-4) {
        vec3 point = origin + view * ((base - origin.z) / view.z);
        light = plain(point, view);
    } else {
        light = sky(view);
    }
    ivec2 pixel = ivec2(gl_FragCoord.xy + tile_pixel);
    float dither = hash(pixel) + hash(pixel + ivec2(7919, 104729)) - 1.0;
    colour = vec4(display_from_linear(tone_curve(light)) + dither / 255.0, 1.0);
}
