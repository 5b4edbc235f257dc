#version 330 core
uniform sampler2D visibility;  // places, of block/terrain.vert.glsl
uniform sampler2D shaded;
uniform float sample_share;  // of a sample's extent, over which colours are averaged

out vec4 colour;

void main() {
    vec2 position = texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).xy;
    vec3 ground = sample_share == 1.0 ? texture(shaded, position).rgb : texture(shaded, position, log2(sample_share)).rgb;
    colour = vec4(ground, 1.0);
}
