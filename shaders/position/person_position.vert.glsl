#version 330 core
#include "common/rotate.glsl"
#include "common/snap.glsl"

uniform mat4 clip;
uniform vec4 root;
uniform vec2 turn;

in vec3 part;
in vec3 part_normal;
in vec3 part_colour;
out vec3 point;
out vec3 facing;

void main() {
    point = root.xyz + root.w * vec3(rotated(part.xy, turn), part.z);
    facing = vec3(rotated(part_normal.xy, turn), part_normal.z);
    gl_Position = snapped(clip * vec4(point, 1.0));
}
