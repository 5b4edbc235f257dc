#version 330 core
// Ground that water shapes, to the horizon, and the bed's water: shaded as on a block.
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
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "bed/soil.glsl"
#include "bed/water.glsl"
const float under_water = any_water;
#include "bed/water_ground.glsl"
uniform float of_far;  // 1: of far ground, 0: of near

// The water's maps hold the bed's own tile. No water lies beyond; the ground there is as damp as at the tile's corner.
vec2 water_position(vec2 position) {
    if (plain < 0.5) return noise_position(position);
    return position.x < 0.5 ? vec2(2.0 * position.x, position.y) : vec2(0.0);
}

vec4 wet_colour(SurfacePoint at) {
    WarpedGround copy = warp_at(at);
    vec2 position = bed_position(at, copy);
    vec2 along = map_offset(at.along.xy);
    vec2 up = map_offset(at.up.xy);
    vec3 to_eye = -normalize(at.offset);
    vec2 size = vec2(textureSize(lighting_map, 0));
    float level = log2(max(0.86 * max(length(along * size), length(up * size)), 1.0));
    BedPoint point = slanting_bed_point(position, along, up);
    point = warped(point, at, copy);
    if (clouds > 0.5) point.sun *= cloud_shade(at.offset);
    vec2 in_water = water_position(position);
    vec3 world_point = vec3(whole_eye + at.offset.xy, at.offset.z + eye.z);
    float one = length(at.along);
    float other = length(at.up);
    float narrow = min(one, other) / crisp;
    float width = sqrt(narrow * max(narrow, 0.5 * max(one, other) / crisp));
    vec3 albedo = ground_albedo(position, point);
    vec4 shown = vec4(ground_at(in_water, level), cover_at(in_water, level));
    WetGround ground = wet_ground(position, point, albedo, water_at(in_water, level), shown, world_point, to_eye, width);
    vec3 light = ground.light * max(1.0 + ground.grainy * grains_of(1.0) * grain(at, 1.0), 0.1);
    vec4 lit = colour_at_eye(light, at, to_eye, point.sun);
    return vec4(as_it_is(lit.rgb, ground.cover, (1.0 - ground.film) * seen_through_air(at)), lit.a);
}

void main() {
    bool far = of_far > 0.5;
    if (is_other_ground(far ? far_ground : near_ground)) {
        colour = vec4(0.0);
    } else {
        colour = wet_colour(far ? far_surface_point() : near_surface_point());
    }
}
