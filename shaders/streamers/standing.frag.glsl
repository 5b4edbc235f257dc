#version 330 core
// Along the camera's axis, how far that is which stands on the ground; of a pixel, the nearest.
uniform vec3 forward;

in vec3 point;  // from the eye
in vec3 facing;
out vec4 depths;

void main() { depths = vec4(dot(point, forward)); }
