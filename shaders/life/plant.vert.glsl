#version 330 core
// A leaf of one of many plants: lit at its corners.
#include "common/rotate.glsl"
#include "common/snap.glsl"
#include "common/colour.glsl"
#include "common/light.glsl"
#include "sky/cloud_shapes.glsl"
#include "bed/bed.glsl"
#include "streamers/streamers.glsl"
#include "world/tile_warp.glsl"

uniform mat4 clip;         // of places as `root` counts them
uniform vec2 root_origin;  // where that counting begins, from the bed's middle, block lengths
uniform float from_eye;    // 1: roots are offsets from the eye
uniform vec3 young;        // of the leaves, their reflectances at the tip
uniform vec3 dry;

in vec3 leaf;         // of a plant that is 1 high
in vec4 leaf_normal;  // and its tint, −1 … 1
in vec4 root;         // and the plant's height
in vec3 form;         // cosine and sine of its turn; tint
out vec4 leaf_colour;  // light, where life/standing.frag.glsl tones it

void main() {
    vec3 position = root.xyz + root.w * vec3(rotated(leaf.xy, form.xy), leaf.z);
    vec3 normal = vec3(rotated(leaf_normal.xy, form.xy), leaf_normal.z);
    BedPoint ground = bed_point(textureLod(lighting_map, map_position(root_origin + root.xy) + warped_ground(root.xy).offset, 0.0));
    if (clouds > 0.5 && from_eye > 0.5) ground.sun *= cloud_shade(position);
    vec3 to_eye = from_eye > 0.5 ? -normalize(position) : direction_to_eye(position);
    // Leaves let light through, and their crown shades its own inside and foot.
    float facing = dot(normal, to_sun);
    float direct = max(facing, 0.0) + 0.45 * max(-facing, 0.0) + 0.15;
    float height = clamp(leaf.z, 0.0, 1.0);
    float open = mix(0.25, 1.0, height);
    vec3 albedo = mix(dry, young, clamp(0.5 + 0.3 * leaf_normal.w + 0.35 * form.z, 0.0, 1.0)) * mix(0.7, 1.0, height);
    vec3 light = sun_light * (ground.sun * direct * open) + sky_light * (ground.sky * (0.35 + 0.65 * open) * (0.8 + 0.2 * normal.z));
    // Sand around them throws some back.
    light += vec3(0.40, 0.29, 0.18) * (sun_light * mix(0.3, 1.0, ground.sun) * max(to_sun.z, 0.0) + sky_light) * (0.6 * (1.0 - 0.5 * height));
    vec3 radiance = albedo * light;
    if (from_eye > 0.5) {
        vec3 haze = haze_along(position);
        radiance = mix(haze, radiance, air_left(length(position))) + glare(-to_eye);
    } else {
        radiance = with_haze(radiance, position, -to_eye);
    }
    leaf_colour = vec4(streamers > 0.5 ? radiance : display_from_linear(tone_curve(radiance)), 1.0);
    gl_Position = snapped(clip * vec4(position, 1.0));
}
