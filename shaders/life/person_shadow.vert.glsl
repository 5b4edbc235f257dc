#version 330 core
// The shadow of a person on the ground: the same mesh, thrown away from the sun. One of several, from points over the
// sun's disc.
#include "common/snap.glsl"
#include "common/colour.glsl"
#include "common/light.glsl"
#include "bed/bed.glsl"
#include "world/tile_warp.glsl"

uniform mat4 clip;
uniform float from_eye;
uniform vec4 root;
uniform vec2 root_position;
uniform vec2 turn;
uniform vec3 from_point;      // of the sun's disc, unit vector
uniform float share;          // of the light, that this point has
uniform float curvature;      // of the planet, 1 / (2 R)
uniform float height_origin;  // that heights count from
uniform sampler2D height_map;

in vec3 part;
in vec3 part_normal;
in vec3 part_colour;
out vec4 leaf_colour;

vec2 place_of(vec2 spot) { return root_position + map_offset(spot - root.xy) + warped_ground(spot).offset - warped_ground(root.xy).offset; }

float ground_height(vec2 spot) {
    return warped_ground(spot).height * textureLod(height_map, place_of(spot), 0.0).r - height_origin - from_eye * dot(spot, spot) * curvature;
}

void main() {
    vec3 top = root.xyz + root.w * vec3(turn.x * part.x - turn.y * part.y, turn.y * part.x + turn.x * part.y, part.z);
    float slant = 1.0 / max(from_point.z, 0.02);
    vec2 spot = top.xy;
    float height = ground_height(spot);
    for (int i = 0; i < 6; ++i) {  // to where the ray meets the ground
        spot = top.xy - from_point.xy * (slant * max(top.z - height, 0.0));
        height = mix(height, ground_height(spot), 0.8);
    }
    BedPoint ground = bed_point(textureLod(lighting_map, place_of(spot), 0.0));
    const vec3 albedo = vec3(0.40, 0.29, 0.18);
    vec3 lit = albedo * (sun_light * max(dot(ground.normal, to_sun), 0.0) + sky_light);
    vec3 left = display_from_linear(tone_curve(albedo * sky_light * 0.85)) / max(display_from_linear(tone_curve(lit)), vec3(1e-3));
    vec3 at = vec3(spot, height + 0.004 * root.w);
    float distance_from_eye = from_eye > 0.5 ? length(at) : length(eye - at);
    float strength = ground.sun * exp(-max(extinction, 0.0) * distance_from_eye);
    leaf_colour = vec4(pow(mix(vec3(1.0), min(left, vec3(1.0)), strength), vec3(share)), 1.0);
    // A little nearer than the ground it lies on.
    at = from_eye > 0.5 ? at * 0.998 : mix(at, eye, 0.002);
    gl_Position = snapped(clip * vec4(at, 1.0));
}
