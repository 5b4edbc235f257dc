#version 330 core
// Prints in the sand of endless ground, over its colours.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/noise.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "world/world_position.glsl"
#include "world/world.glsl"
#include "life/track.glsl"

void main() {
    SurfacePoint at = far_surface_point();
    if (dot(at.offset, at.offset) == 0.0) discard;  // the sky
    WarpedGround copy = warp_at(at);
    vec2 position = bed_position(at, copy);
    vec3 to_eye = -normalize(at.offset);
    vec4 sand = sand_colour(at, position);
    vec3 uneven = unevenness(sand.a) * relief(at, sand.a);
    BedPoint point = warped(slanting_bed_point(position, map_offset(at.along.xy), map_offset(at.up.xy)), at, copy);
    float span = 1.0 / metre;
    Trodden print = trodden(span * (at.offset.xy - print_root.xy), point.normal, uneven.xy, to_eye, span * length(at.along), span * at.up.xy);
    // Coarse grains and crusts give way less.
    print.share *= bare_sand(position) * (1.0 - plain * rock) * mix(0.5, 1.0, smoothstep(0.2, 0.7, sand.a));
    if (print.share < 0.004) discard;
    vec3 albedo = albedo_of(sand, grains_of(sand.a) * grain(at, sand.a) + 0.1 * uneven.z);
    float direct = roughened(point.sun * print.direct, print.normal, to_eye, least_facing(0.0));
    BedPoint within = BedPoint(sky_normal(print, point), point.sun * print.sun, point.sky);
    vec3 light = ground_light_of(albedo, direct, within, to_eye, 1.0) + between_walls(print, albedo, point);
    colour = vec4(colour_at_eye(light, at, to_eye, point.sun).rgb, print.share);
}
