#version 330 core
// A texture's next coarser mipmap.
uniform sampler2D finer;
uniform vec2 size;  // of the mipmap, texels

out vec4 mean;

void main() { mean = textureLod(finer, gl_FragCoord.xy / size, 0.0); }
