#version 330 core
// Marks the pixels all of whose samples see the same ground, that between two distances.
#include "world_place.glsl"

uniform float least_distance;
uniform float most_distance;

void main() {
    float slant;
    bool whole;
    SeenPlace place = pixel_place(slant, whole);
    float range = length(place.offset);
    if (!whole || range < least_distance || range >= most_distance) discard;
}
