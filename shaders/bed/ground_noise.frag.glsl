#version 330 core
// The unevenness of the ground's colour over the block, made once: each 0 … 1 for −1 … 1.
#include "common/noise.glsl"

uniform vec2 extent;  // of the block
uniform int periodic;  // 1: the block is repeated; 2: and even

in vec2 position;
out vec4 noise;

float features(float fineness) {
    ivec2 period = max(ivec2(fineness * extent + 0.5), 1);
    return periodic_noise(position * vec2(period), period);
}

void main() {
    vec2 world = (position - 0.5) * extent;
    float sand_broad = (value_noise(world * 5.0) + 0.5 * value_noise(world * 11.0 + 7.3)) / 1.5;
    float sand_fine = value_noise(world * 43.0 + 3.1);
    float rock_broad = (value_noise(world * 9.0) + 0.5 * value_noise(world * 23.0)) / 1.5;
    if (periodic == 1) {
        sand_broad = (features(5.0) + 0.5 * features(11.0)) / 1.5;
        sand_fine = features(43.0);
    }
    if (periodic == 2) sand_broad = sand_fine = rock_broad = 0.0;
    noise = 0.5 + 0.5 * vec4(sand_broad, sand_fine, rock_broad, 0.0);
}
