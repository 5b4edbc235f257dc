#version 330 core
#include "common/colour.glsl"

uniform float linear_light;  // 1: radiances, not display values

in vec4 painted;
out vec4 colour;

void main() {
    colour = painted;
    if (linear_light > 0.5) colour.rgb = linear_from_display(colour.rgb);
}
