#version 330 core
// As block/visibility.frag.glsl, of a surface with water: where it is and how high, and that it is one.
uniform vec2 height_span;  // of the surface: the lowest, and how much higher the highest

in vec2 at_sample;
in float world_height;
out vec4 visibility;

void main() { visibility = vec4(at_sample, (world_height - height_span.x) / height_span.y, 1.0); }
