#version 330 core
// The soft shadow of one of many plants on the ground around it, away from the sun: what it leaves of the colour there.
#include "common/snap.glsl"
#include "common/colour.glsl"
#include "common/light.glsl"
#include "bed/bed.glsl"
#include "world/tile_warp.glsl"

uniform mat4 clip;
uniform vec2 root_origin;
uniform float from_eye;
uniform float curvature;         // of the planet, 1 / (2 R)
uniform float height_origin;     // that roots' heights count from
uniform float width;             // of a plant that is 1 high
uniform sampler2D height_map;

in vec2 strip;  // −1 … 1 across the shadow, 0 … 1 along it
in vec4 root;
out vec2 in_shadow;
out vec3 left;  // of light, display values
out float strength;

void main() {
    vec2 away = -normalize(to_sun.xy + vec2(1e-5, 0.0));
    float slant = min(length(to_sun.xy) / max(to_sun.z, 0.05), 5.0);
    float half_width = width * root.w;
    float reach = (0.75 * slant + 2.0 * width) * root.w;
    vec2 spot = root.xy + vec2(-away.y, away.x) * (strip.x * half_width) + away * (reach * strip.y - half_width);
    WarpedGround copy = warped_ground(spot);
    vec2 position = (root_origin + spot) / extent + 0.5 + copy.offset;
    float height = copy.height * textureLod(height_map, position, 0.0).r - height_origin + 0.04 * root.w - dot(spot, spot) * curvature;
    vec3 at = vec3(spot, height);
    BedPoint ground = bed_point(textureLod(lighting_map, map_position(root_origin + root.xy) + warped_ground(root.xy).offset, 0.0));
    vec3 albedo = vec3(0.40, 0.29, 0.18);
    float direct = max(dot(ground.normal, to_sun), 0.0);
    vec3 lit = albedo * (sun_light * direct + sky_light);
    left = display_from_linear(tone_curve(albedo * sky_light * 0.8)) / max(display_from_linear(tone_curve(lit)), vec3(1e-3));
    left = min(left, vec3(1.0));
    float distance_from_eye = from_eye > 0.5 ? length(at) : length(eye - at);
    strength = ground.sun * exp(-max(extinction, 0.0) * distance_from_eye);
    in_shadow = strip;
    // A little nearer than the ground it lies on.
    at = from_eye > 0.5 ? at * 0.997 : mix(at, eye, 0.003);
    gl_Position = snapped(clip * vec4(at, 1.0));
}
