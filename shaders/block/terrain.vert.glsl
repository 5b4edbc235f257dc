#version 330 core
#include "common/snap.glsl"

uniform mat4 clip_from_world;
uniform vec2 extent;

in vec2 east_north;  // 0 … 1
in float height;
out vec2 at_sample;
out float world_height;

void main() {
    at_sample = east_north;
    world_height = height;
    gl_Position = snapped(clip_from_world * vec4((east_north - 0.5) * extent, height, 1.0));
}
