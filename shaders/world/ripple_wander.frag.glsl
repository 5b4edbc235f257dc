#version 330 core
// How wind ripples wander over sand, made once and repeated: turns added to their phase, a second train of waves, and how
// high they stand. Stored as 0 … 1; wander_at() of world/world_near.frag.glsl gives the ranges.
#include "common/noise.glsl"

uniform float features;  // along a side, about seven ripples to each

in vec2 position;
out vec4 wander;

float noise(float fineness, vec2 aside) {
    float count = floor(fineness * features + 0.5);
    return periodic_noise(position * count + aside, ivec2(int(count)));
}

void main() {
    float turns = 2.4 * noise(0.09, vec2(0.4)) + 1.7 * noise(0.31, vec2(5.3)) + 0.45 * noise(1.3, vec2(2.9));
    // Where it is nought crests end or fork.
    vec2 second = vec2(0.12 + noise(0.8, vec2(0.0)) + 0.8 * noise(1.7, vec2(3.7)), noise(0.8, vec2(17.3)) + 0.8 * noise(1.7, vec2(29.1)));
    // Patches where they stand high, and others with hardly any.
    float height = 0.62 + 0.45 * noise(0.11, vec2(7.7)) + 0.38 * noise(0.29, vec2(9.1)) + 0.15 * noise(0.9, vec2(1.3));
    wander = vec4(0.5 + 0.1 * turns, 0.5 + 0.25 * second, clamp(height, 0.2, 1.15) / 1.15);
}
