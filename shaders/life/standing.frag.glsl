#version 330 core
// What stands on the ground, seen through blown sand where there is some: then its light is toned here.
#include "common/colour.glsl"
#include "streamers/streamers.glsl"

uniform vec2 first_of_tile;  // its first sample in the target
uniform float factor;        // samples along a pixel

in vec4 leaf_colour;
out vec4 colour;

void main() {
    colour = leaf_colour;
    if (streamers > 0.5) {
        ivec2 pixel = ivec2(floor((floor(gl_FragCoord.xy) - first_of_tile) / factor));
        colour.rgb = display_from_linear(tone_curve(through_streamers(leaf_colour.rgb, pixel)));
    }
}
