#version 330 core
#include "common/rotate.glsl"
#include "common/snap.glsl"

uniform mat4 clip;  // of places as `root` counts them

in vec3 leaf;
in vec4 leaf_normal;
in vec4 root;
in vec3 form;
out vec3 point;
out vec3 facing;

void main() {
    point = root.xyz + root.w * vec3(rotated(leaf.xy, form.xy), leaf.z);
    facing = vec3(rotated(leaf_normal.xy, form.xy), leaf_normal.z);
    gl_Position = snapped(clip * vec4(point, 1.0));
}
