#version 330 core
// As bed/shade_scenic.frag.glsl, of ground that water shapes and with water over it: for maps, and through a lens.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "bed/drape.glsl"
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "bed/water.glsl"
const float under_water = any_water;
#include "bed/water_ground.glsl"

in vec2 position;
out vec4 colour;  // alpha: how much of the grain is seen

void main() {
    vec3 world_point = vec3((position - 0.5) * extent, 0.0);
    colour = water_ground(position, world_point, pixel_width_at(world_point), 0.0);
}
