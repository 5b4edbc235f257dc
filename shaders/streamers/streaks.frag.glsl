#version 330 core
// Turbulence of the air, made once and repeated: two independent noises, 0 … 1.
#include "common/noise.glsl"

uniform float features;  // along a side

in vec2 position;
out vec4 streaks;

float noise(float fineness, vec2 aside) {
    float count = floor(fineness * features + 0.5);
    return periodic_noise(position * count + aside, ivec2(int(count)));
}

void main() {
    float one = 0.6 * noise(1.0, vec2(0.4)) + 0.4 * noise(2.7, vec2(2.9));
    float other = 0.6 * noise(1.0, vec2(41.3)) + 0.4 * noise(2.7, vec2(57.1));
    streaks = vec4(0.5 + 0.5 * one, 0.5 + 0.5 * other, 0.0, 1.0);
}
