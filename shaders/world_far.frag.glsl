#version 330 core
// Sand so far that a ripple is finer than a sample.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"
#include "rock.glsl"
#include "world.glsl"

void main() {
    SeenPlace at = far_place();
    BedPoint point = slanting_bed_point(bed_place(at), at.along.xy / extent, at.up.xy / extent);
    vec3 to_eye = -normalize(at.offset);
    vec3 albedo = albedo_of(sand_colour(at), 0.10 * sand_grain * grain(at));
    if (marks > 1.5) weather(point.normal, albedo, in_metres(at.offset), metres(length(at.along) + length(at.up)), rock_share(bed_place(at)));
    colour = seen(ground_light(albedo, point, to_eye, 1.0), at, to_eye);
}
