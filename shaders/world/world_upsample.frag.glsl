#version 330 core
// Gives the samples of pixels that are coloured as a whole their colour.
uniform vec2 first_sample;  // of the lower left pixel
uniform int factor;         // samples along each side of a pixel
uniform sampler2D pixels;   // alpha 0: not coloured

out vec4 colour;

void main() {
    ivec2 pixel = ivec2(floor((gl_FragCoord.xy - first_sample) / float(factor)));
    colour = texelFetch(pixels, clamp(pixel, ivec2(0), textureSize(pixels, 0) - 1), 0);
    if (colour.a < 0.5) discard;
}
