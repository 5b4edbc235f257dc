#version 330 core
// Light that a lens has gathered, as it is shown: toned once, as a mean, and for 8 bits with one step of dither, since what
// is blurred has slow gradients.
#include "common/colour.glsl"
#include "common/noise.glsl"

uniform sampler2D accumulated;  // times opacity, which is its alpha; rows run downward
uniform vec2 first_pixel;    // in the picture
uniform float dithered;      // 1: for 8 bits

out vec4 colour;

void main() {
    vec4 light = texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0);
    vec3 radiance = light.rgb / max(light.a, 1e-3);
    ivec2 pixel = ivec2(gl_FragCoord.xy + first_pixel);
    float dither = hash(pixel) + hash(pixel + ivec2(7919, 104729)) - 1.0;
    colour = vec4(display_from_linear(tone_curve(radiance)) + dithered * dither / 255.0, light.a);
}
