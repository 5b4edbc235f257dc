#version 330 core
// The colour of a sample of the block's sides.
#include "block/side_colour.glsl"

uniform sampler2D visibility;  // grounds and surfaces, of block/side.vert.glsl

in vec3 world_point;
out vec4 colour;

void main() { colour = vec4(side_colour(world_point, texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).xy), 1.0); }
