#version 330 core
uniform sampler2D seen;  // places, of block/terrain.vert.glsl
uniform sampler2D shaded;
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;
uniform float linear_light;  // 1: the colours are radiances, not display values

out vec4 colour;

void main() {
    vec2 place = texelFetch(seen, ivec2(gl_FragCoord.xy), 0).xy;
    float speck = texture(grain, place * grain_scale).r - 0.5;
    vec4 ground = texture(shaded, place);  // alpha: how much of the grain is seen
    float grainy = 1.0 + grain_strength * ground.a * speck;
    if (linear_light > 0.5) grainy *= grainy;
    colour = vec4(ground.rgb * grainy, 1.0);
}
