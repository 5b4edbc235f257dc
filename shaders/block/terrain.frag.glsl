#version 330 core
uniform sampler2D visibility;  // places, of block/terrain.vert.glsl
uniform sampler2D shaded;
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;
uniform float sample_share;  // of a sample's extent, over which colours are averaged
uniform float linear_light;  // 1: the colours are radiances, not display values

out vec4 colour;

void main() {
    vec2 position = texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).xy;
    vec2 grain_position = position * grain_scale;
    float speck = (sample_share == 1.0 ? texture(grain, grain_position) : texture(grain, grain_position, log2(sample_share))).r - 0.5;
    vec4 ground = sample_share == 1.0 ? texture(shaded, position) : texture(shaded, position, log2(sample_share));  // alpha: how much of the grain is seen
    float grainy = 1.0 + grain_strength * ground.a * speck;
    if (linear_light > 0.5) grainy *= grainy;
    colour = vec4(ground.rgb * grainy, 1.0);
}
