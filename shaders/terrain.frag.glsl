#version 330 core
uniform sampler2D seen;  // places, of terrain.vert.glsl
uniform sampler2D shaded;
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;

out vec4 colour;

void main() {
    vec2 place = texelFetch(seen, ivec2(gl_FragCoord.xy), 0).xy;
    float speck = texture(grain, place * grain_scale).r - 0.5;
    vec4 ground = texture(shaded, place);  // alpha: how much of the grain is seen
    colour = vec4(ground.rgb * (1.0 + grain_strength * ground.a * speck), 1.0);
}
