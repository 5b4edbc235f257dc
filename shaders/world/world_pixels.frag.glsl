#version 330 core
// Marks the pixels all of whose samples see the same ground, by depth: before the middle near ones, behind it far ones.
#include "world/world_place.glsl"

uniform float near_to;

void main() {
    float slant;
    bool whole;
    SeenPlace place = pixel_place(slant, whole);
    if (!whole) discard;
    gl_FragDepth = length(place.offset) < near_to ? 0.25 : 0.75;
}
