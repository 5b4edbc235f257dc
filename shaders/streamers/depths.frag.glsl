#version 330 core
// Along the camera's axis, how far the ground is that the corners of each pixel see.
uniform vec3 forward;
uniform sampler2D offsets;  // of visible points from the eye; none: 0
uniform vec2 first_sample;  // of the tile's lower left pixel
uniform int factor;

out vec4 depths;

float ground_depth(ivec2 at) {
    vec3 offset = texelFetch(offsets, at, 0).xyz;
    return offset == vec3(0.0) ? 1e6 : dot(offset, forward);
}

void main() {
    ivec2 low = ivec2(first_sample) + factor * ivec2(gl_FragCoord.xy);
    int last = factor - 1;
    depths = vec4(ground_depth(low), ground_depth(low + ivec2(last, 0)), ground_depth(low + ivec2(0, last)), ground_depth(low + ivec2(last)));
}
