#version 330 core
// The surroundings, enlarged to samples, so that what is translucent can be blended over them.
uniform sampler2D background;
uniform int factor;    // samples along each side of a pixel
uniform int margin_x;  // samples before this tile
uniform int margin_y;
uniform int columns;   // of pixels in this tile
uniform int rows;      // the picture's rows run downward

out vec4 colour;

void main() {
    ivec2 inside = ivec2(floor((gl_FragCoord.xy - vec2(margin_x, margin_y)) / float(factor)));
    ivec2 pixel = clamp(ivec2(inside.x, rows - 1 - inside.y), ivec2(0), ivec2(columns - 1, rows - 1));
    colour = vec4(texelFetch(background, pixel, 0).rgb, 1.0);
}
