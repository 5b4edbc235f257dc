#version 330 core
// Prints in the sand of a block, over its colours.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/noise.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "life/track.glsl"

uniform sampler2D visibility;  // places, of block/terrain.vert.glsl
uniform sampler2D height_map;

out vec4 colour;

void main() {
    vec2 position = texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).xy;
    vec3 at = vec3((position - 0.5) * extent, textureLod(height_map, position, 0.0).r);
    vec3 to_eye = direction_to_eye(at);
    BedPoint point = bed_point(textureLod(lighting_map, position, 0.0));
    float span = 1.0 / metre;
    float across = span * angle * distance(eye, at);
    float facing = dot(point.normal, to_eye);
    vec2 up = normalize(to_eye - facing * point.normal + 1e-6).xy * (across / max(facing, 0.05));
    Trodden print = trodden(span * (at.xy - print_root.xy), point.normal, vec2(0.0), to_eye, across, up);
    print.share *= bare_sand(position) * (1.0 - rock);
    if (print.share < 0.004) discard;
    float n_dot_l = max(dot(print.normal, to_sun), 0.02);
    float direct = point.sun * print.direct / n_dot_l * oren_nayar(n_dot_l, max(dot(print.normal, to_eye), 0.0), dot(to_sun, to_eye));
    BedPoint within = BedPoint(sky_normal(print, point), point.sun * print.sun, point.sky);
    vec3 albedo = ground_albedo(position, point);
    vec3 light = ground_light_of(albedo, direct, within, to_eye, 1.0) + between_walls(print, albedo, point);
    colour = vec4(display_from_linear(tone_curve(with_haze(light, at, -to_eye))), print.share);
}
