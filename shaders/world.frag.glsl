#version 330 core
// Sand to the horizon, shaded a sample at a time.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"

uniform float extinction;     // of the air, per block length
uniform vec2 wind;            // unit vector
uniform float ripple_length;  // block lengths
uniform float ripple_phase;   // of the eye's place, in turns
uniform float ripple_slope;   // steepest
uniform vec2 whole_eye;       // the eye's place, not reduced to one period

in vec3 offset;
out vec4 colour;

void main() {
    vec2 world = eye.xy + offset.xy;
    vec2 place = world / extent + 0.5;
    BedPoint point = bed_point(place);
    float far = length(offset);
    vec3 to_eye = -offset / far;

    // Wind ripples, which the grid of the bed is too coarse for.
    vec2 at = offset.xy / ripple_length;
    vec2 noise_at = (whole_eye + offset.xy) / ripple_length;
    float warp = 1.2 * value_noise(noise_at / 9.0) + 0.5 * value_noise(noise_at / 4.0 + 3.7);
    vec2 slope = -point.normal.xy / max(point.normal.z, 0.1);
    float phase = dot(at, wind) + ripple_phase + warp;
    float footprint = fwidth(phase);
    float steep = length(slope);
    float seen = (1.0 - smoothstep(0.25, 0.6, footprint)) * (1.0 - smoothstep(0.36, 0.50, steep));
    float turn = 6.2831853 * fract(phase);
    float wave = cos(turn) + 0.25 * cos(2.0 * turn);
    slope += wind * (ripple_slope * seen * wave);
    point.normal = normalize(vec3(-slope, 1.0));

    vec3 light = ground_light(ground_albedo(place, point), point, to_eye, 1.0);
    light *= 1.0 - 0.36 * ripple_slope * seen * sin(turn);
    light = mix(haze_towards(-to_eye), light, exp(-extinction * far));
    colour = vec4(display_from_linear(tone_curve(light)), 1.0);
}
