#version 330 core
uniform sampler2D shaded;
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;

in vec2 place;
out vec4 colour;

void main() {
    float speck = texture(grain, place * grain_scale).r - 0.5;
    colour = vec4(texture(shaded, place).rgb * (1.0 + grain_strength * speck), 1.0);
}
