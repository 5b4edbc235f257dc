#version 330 core
#include "common/snap.glsl"

uniform mat4 clip_from_world;
uniform vec2 extent;
uniform vec2 height_range;  // of all grounds and surfaces

in vec2 east_north;  // 0 … 1
in vec2 normal;
in vec3 heights;  // of this corner, of the ground and of the surface above it
out vec2 at_sample;  // ground and surface, 0 … 1 over their range
out vec3 world_point;
out vec2 outward;

invariant gl_Position;  // of a face that is drawn again

void main() {
    at_sample = (heights.yz - height_range.x) / (height_range.y - height_range.x);
    world_point = vec3((east_north - 0.5) * extent, heights.x);
    outward = normal;
    gl_Position = snapped(clip_from_world * vec4(world_point, 1.0));
}
