#version 330 core
#include "bed/bed.glsl"
#include "world/far_copies.glsl"

uniform vec2 corner;   // offsets from the eye, block lengths
uniform float across;
uniform int numbers;   // which are asked for

in vec2 place;
out vec4 found;

void main() {
    GroundCopy copy = ground_copy(corner + across * place);
    if (numbers == 0) found = vec4(copy.aside, copy.height, 0.0);
    if (numbers == 1) found = vec4(copy.way[0], copy.way[1]);
    if (numbers == 2) found = vec4(copy.growth, copy_slope(copy, vec2(0.3, -0.2), 0.02));
}
