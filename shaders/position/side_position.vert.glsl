#version 330 core
#include "common/snap.glsl"

uniform mat4 clip_from_world;
uniform vec2 extent;

in vec2 east_north;  // 0 … 1
in vec2 normal;
in vec3 heights;  // of this corner, of the ground and of the surface above it
out vec3 point;
out vec3 facing;

void main() {
    point = vec3((east_north - 0.5) * extent, heights.x);
    facing = vec3(normal, 0.0);
    gl_Position = snapped(clip_from_world * vec4(point, 1.0));
}
