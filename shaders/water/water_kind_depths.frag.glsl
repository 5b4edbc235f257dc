#version 330 core
// Tells the pixels of a block with water apart by depth, each by the kind that it is known to have.
uniform sampler2D kinds;

void main() { gl_FragDepth = texelFetch(kinds, ivec2(gl_FragCoord.xy), 0).r; }
