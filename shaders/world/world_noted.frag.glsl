#version 330 core
// What samples see of near or far ground, in the target in which other things are drawn after it.
#include "world/world_place.glsl"

uniform int ground;         // of world/world_place.glsl
uniform vec2 depth_range;   // the depths that the target tells apart, along the camera's axis

out vec4 seen;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (ground_at(at) != ground) discard;
    seen = seen_at(at);
    if (ground == far_ground) seen.w = -seen.w;
    float share = depth_range.y / (depth_range.y - depth_range.x);
    gl_FragDepth = share - share * nearness_at(at);
}
