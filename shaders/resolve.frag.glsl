#version 330 core
// Averages the samples of each pixel in (nearly) linear light over the background.
uniform sampler2D samples;
uniform sampler2D background;
uniform int factor;          // samples along each side of a pixel
uniform int margin_x;  // samples before this tile that are thrown away
uniform int margin_y;
uniform int rows;            // of pixels in this tile: the picture's rows run downward

out vec4 colour;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 corner = ivec2(margin_x, margin_y) + ivec2(pixel.x, rows - 1 - pixel.y) * factor;
    vec3 sum = vec3(0.0);
    float covered = 0.0;
    for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
            vec4 texel = texelFetch(samples, corner + ivec2(i, j), 0);
            sum += texel.rgb * texel.rgb;
            covered += texel.a;
        }
    }
    vec3 behind = texelFetch(background, pixel, 0).rgb;
    float all = float(factor * factor);
    colour = vec4(sqrt((sum + behind * behind * (all - covered)) / all), 1.0);
}
