#version 330 core
#include "common/snap.glsl"

uniform mat4 clip;  // of places as `root` counts them

in vec3 leaf;
in vec4 leaf_normal;
in vec4 root;
in vec3 form;
out vec3 point;
out vec3 facing;

vec2 turned(vec2 p) { return vec2(form.x * p.x - form.y * p.y, form.y * p.x + form.x * p.y); }

void main() {
    point = root.xyz + root.w * vec3(turned(leaf.xy), leaf.z);
    facing = vec3(turned(leaf_normal.xy), leaf_normal.z);
    gl_Position = snapped(clip * vec4(point, 1.0));
}
