#version 330 core
#include "common/snap.glsl"

uniform mat4 clip_from_world;

in vec3 point;
in vec4 paint;  // a colour with opacity, or a place in the sheet's texture
out vec4 painted;

void main() {
    painted = paint;
    gl_Position = snapped(clip_from_world * vec4(point, 1.0));
}
