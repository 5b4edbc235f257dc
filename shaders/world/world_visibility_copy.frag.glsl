#version 330 core
// What samples see of near or far ground, in the target in which other things are drawn after it.
#include "world/world_position.glsl"

uniform int ground;         // of world/world_position.glsl
uniform vec2 depth_range;   // range of the target's depths, along the camera's axis

out vec4 visibility;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (ground_at(at) != ground) discard;
    visibility = visibility_at(at);
    if (ground == far_ground) visibility.w = -visibility.w;
    float share = depth_range.y / (depth_range.y - depth_range.x);
    gl_FragDepth = share - share * reversed_z_at(at);
}
