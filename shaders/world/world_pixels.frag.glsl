#version 330 core
// Tells pixels apart, by depth: those all of whose samples see the same near ground, and those where it is the same far ground. Of
// the others, which samples are coloured by themselves, red is 1 where any of them sees near ground, green where any sees far ground.
#include "world/world_place.glsl"

uniform float near_to;
uniform float near_depth;
uniform float far_depth;
uniform float other_depth;

out vec4 colour;

void main() {
    float slant;
    bool whole;
    SeenPlace place = pixel_place(slant, whole);
    vec2 seen = vec2(0.0);
    ivec2 first = ivec2(first_sample) + factor * ivec2(gl_FragCoord.xy);
    for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
            int ground = ground_at(first + ivec2(i, j));
            seen = max(seen, vec2(ground == near_ground ? 1.0 : 0.0, ground == far_ground ? 1.0 : 0.0));
        }
    }
    colour = whole ? vec4(0.0) : vec4(seen, 0.0, 0.0);
    gl_FragDepth = !whole ? other_depth : length(place.offset) < near_to ? near_depth : far_depth;
}
