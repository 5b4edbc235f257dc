#version 330 core
uniform sampler2D seen;  // places, of block/terrain.vert.glsl
uniform sampler2D shaded;

out vec4 colour;

void main() {
    vec2 place = texelFetch(seen, ivec2(gl_FragCoord.xy), 0).xy;
    colour = vec4(texture(shaded, place).rgb, 1.0);
}
