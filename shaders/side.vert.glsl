#version 330 core
#include "snap.glsl"

uniform mat4 clip_from_world;
uniform vec2 extent;

in vec2 east_north;  // 0 … 1
in vec2 normal;
in vec3 heights;  // of this corner, of the ground and of the surface above it
out vec3 world_point;
out vec2 outward;
out float ground;
out float surface;

void main() {
    world_point = vec3((east_north - 0.5) * extent, heights.x);
    outward = normal;
    ground = heights.y;
    surface = heights.z;
    gl_Position = snapped(clip_from_world * vec4(world_point, 1.0));
}
