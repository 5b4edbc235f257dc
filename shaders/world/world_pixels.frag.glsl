#version 330 core
// Tells pixels apart, by depth: those all of whose samples see the same near ground, of these the plain ones (is_plain() below),
// level or steep, and those where it is the same far ground. Of
// the others, which samples are coloured by themselves, red is 1 where any of them sees near ground, green where any sees far ground.
#include "world/world_place.glsl"

uniform float near_to;
uniform float level_depth;
uniform float steep_depth;
uniform float near_depth;
uniform float far_depth;
uniform float other_depth;

uniform float texels;          // of the bed's maps to a block length
uniform float exaggeration;    // of heights
uniform vec2 extent;           // of the block
uniform float varied;          // of world/far_copies.glsl
uniform vec2 eye_from_middle;

out vec4 colour;

// Whether one look at the bed's maps does for a pixel, which is of no far copy.
bool is_plain(SeenPlace place) {
    float across = max(dot(place.along.xy, place.along.xy), dot(place.up.xy, place.up.xy));
    const float most_texels = 1.0;
    bool small = across * texels * texels < most_texels * most_texels;
    bool as_it_is = varied < 0.5 || length(eye_from_middle + place.offset.xy / extent) < 0.7;
    return small && as_it_is;
}

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
    gl_FragDepth = !whole ? other_depth : length(place.offset) >= near_to ? far_depth : !is_plain(place) ? near_depth : fall_at(place) > none_slid * exaggeration ? steep_depth : level_depth;
}
