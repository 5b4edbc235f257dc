#version 330 core
// The ground around the camera: offsets from the eye.
#include "common/snap.glsl"

uniform mat4 clip_from_eye;  // without the eye's place

in vec3 offset;
out vec3 at_sample;

void main() {
    at_sample = offset;
    gl_Position = snapped(clip_from_eye * vec4(offset, 1.0));
}
