#version 330 core
#include "bed/bed.glsl"
#include "world/tile_warp.glsl"

uniform vec2 corner;   // offsets from the eye, block lengths
uniform float across;
uniform int numbers;   // which are asked for

in vec2 position;
out vec4 found;

void main() {
    WarpedGround copy = warped_ground(corner + across * position);
    if (numbers == 0) found = vec4(copy.offset, copy.height, 0.0);
    if (numbers == 1) found = vec4(copy.jacobian[0], copy.jacobian[1]);
    if (numbers == 2) found = vec4(copy.height_gradient, warped_slope(copy, vec2(0.3, -0.2), 0.02));
}
