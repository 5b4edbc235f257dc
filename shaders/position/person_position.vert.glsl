#version 330 core
#include "common/snap.glsl"

uniform mat4 clip;
uniform vec4 root;
uniform vec2 turn;

in vec3 part;
in vec3 part_normal;
in vec3 part_colour;
out vec3 point;
out vec3 facing;

vec2 turned(vec2 p) { return vec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y); }

void main() {
    point = root.xyz + root.w * vec3(turned(part.xy), part.z);
    facing = vec3(turned(part_normal.xy), part_normal.z);
    gl_Position = snapped(clip * vec4(point, 1.0));
}
