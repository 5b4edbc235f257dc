#version 330 core
#include "common/colour.glsl"

uniform sampler2D sheet;
uniform float linear_light;  // 1: radiances, not display values

in vec4 painted;
out vec4 colour;

void main() {
    colour = texture(sheet, painted.xy);
    if (linear_light > 0.5) colour.rgb = linear_from_display(colour.rgb);
}
