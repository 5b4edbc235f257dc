#version 330 core
// As block/terrain.frag.glsl, where a pixel's samples have its colour.
uniform sampler2D shaded;  // pixels, of water/water_pixels.frag.glsl
uniform float samples_along;      // samples along each side of a pixel
uniform vec2 sample_offset;

out vec4 colour;

void main() { colour = vec4(texelFetch(shaded, ivec2((gl_FragCoord.xy - sample_offset) / samples_along), 0).rgb, 1.0); }
