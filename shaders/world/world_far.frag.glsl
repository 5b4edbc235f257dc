#version 330 core
// Sand so far that a ripple is finer than a sample.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "sky/cloud_shapes.glsl"
#include "common/noise.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "bed/drape.glsl"
#include "world/rock.glsl"
#include "world/pavement.glsl"
#include "world/world_position.glsl"
#include "world/world.glsl"
#include "world/wear.glsl"

vec4 far_colour(SurfacePoint at) {
    WarpedGround copy = warp_at(at);
    vec2 position = bed_position(at, copy);
    vec2 along = map_offset(at.along.xy);
    vec2 up = map_offset(at.up.xy);
    vec3 to_eye = -normalize(at.offset);
    vec4 sand = sand_colour(at, position);
    Laid laid = slanting_drape(position, along, up);
    if (draped > 0.5) sand.a *= 1.0 - laid.share;
    vec2 surface = textureGrad(surface_map, position, along, up).rg;
    vec2 share = uneven_share(sand.a, surface.g);
    vec3 uneven = share.x * unevenness(sand.a) * relief(at, sand.a);
    float rocky = has_rock() ? weathered(position) : 0.0;
    if (draped > 0.5) {
        uneven *= 1.0 - laid.share;
        rocky *= 1.0 - laid.share;
    }
    BedPoint point = warped(slanting_bed_point(position, along, up), at, copy);
    vec2 slope = -point.normal.xy / max(point.normal.z, 0.1);
    if (has_rock()) share.y *= level_share(length(slope), rocky);
    vec3 albedo = albedo_of(sand, share.y * grains_of(sand.a) * grain(at, sand.a) + 0.1 * uneven.z);
    if (clouds > 0.5) point.sun *= cloud_shade(at.offset);
    float standing = rippled(sand.a, surface.r, length(slope));
    float steepness = share.x * unevenness(sand.a).x * (draped > 0.5 ? 1.0 - laid.share : 1.0);
    vec2 kept = kept_unevenness(at, dot(point.normal, to_sun), steepness);
    point.normal = normalize(vec3(point.normal.xy - kept.x * uneven.xy * point.normal.z, point.normal.z));
    if (has_rock()) wear(point.normal, albedo, at, rocky, length(slope));
    albedo = with_drape(albedo, laid);
    float spread = 0.7 * ripple_slope * standing * dot(facing_of(slope), to_sun.xy);
    float n_dot_l = mean_facing(dot(point.normal, to_sun), sqrt(spread * spread + kept.y));
    float direct = roughened(point.sun * n_dot_l, point.normal, to_eye, least_facing(rocky));
    vec4 lit = colour_at_eye(ground_light_of(albedo, direct, point, to_eye, 1.0), at, to_eye, point.sun);
    return vec4(as_it_is(lit.rgb, laid, seen_through_air(at)), lit.a);
}

void main() { colour = is_other_ground(far_ground) ? vec4(0.0) : far_colour(far_surface_point()); }
