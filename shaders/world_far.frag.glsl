#version 330 core
// Sand so far that a ripple is finer than a sample.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"
#include "world.glsl"

void main() {
    vec2 place = bed_place();
    BedPoint point = slanting_bed_point(place);
    vec3 to_eye = -normalize(offset);
    vec2 across = fwidth(offset.xy);
    vec3 albedo = sand_albedo(place, 0.10 * sand_grain * grain(max(across.x, across.y)));
    colour = seen(ground_light(albedo, point, to_eye, 1.0), to_eye);
}
