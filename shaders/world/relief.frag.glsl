#version 330 core
// Unevenness of sand that repeats, made once: slopes along x and y, and how much lighter it is, each 0 … 1 for −1 … 1. Every
// octave has as much slope as the next, as rough surfaces have.
#include "common/noise.glsl"

in vec2 position;
out vec4 relief;

// Of a corner of the lattice: a slope of its own.
float rise(ivec2 corner, ivec2 period, vec2 from_corner) {
    corner -= period * (corner / period);
    float turn = 6.2831853 * hash(corner + 131 * period);
    return dot(vec2(cos(turn), sin(turn)), from_corner);
}

// Gradient noise with a whole number of features (Perlin 2002).
float noise(vec2 p, int features) {
    ivec2 period = ivec2(features);
    vec2 whole = floor(p);
    vec2 t = p - whole;
    vec2 s = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    ivec2 at = ivec2(whole);
    float south = mix(rise(at, period, t), rise(at + ivec2(1, 0), period, t - vec2(1.0, 0.0)), s.x);
    float north = mix(rise(at + ivec2(0, 1), period, t - vec2(0.0, 1.0)), rise(at + ivec2(1), period, t - vec2(1.0)), s.x);
    return mix(south, north, s.y);
}

vec3 octave(int features) {
    const float step = 0.05;
    vec2 p = position * float(features) + float(features);
    float here = noise(p, features);
    return vec3(noise(p + vec2(step, 0.0), features) - here, noise(p + vec2(0.0, step), features) - here, 0.0) / step + vec3(0.0, 0.0, here);
}

void main() {
    vec3 sum = octave(5) + octave(11) + octave(23) + 1.1 * octave(47) + 1.25 * octave(90) + 1.5 * octave(180);
    relief = vec4(0.5 + 0.15 * sum, 1.0);
}
