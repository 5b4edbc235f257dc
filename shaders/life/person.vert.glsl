#version 330 core
// A person on the bed, lit at the corners of a fine mesh.
#include "common/rotate.glsl"
#include "common/snap.glsl"
#include "common/colour.glsl"
#include "common/light.glsl"
#include "sky/cloud_shapes.glsl"
#include "bed/bed.glsl"
#include "streamers/streamers.glsl"

uniform mat4 clip;        // of places as `root` counts them
uniform float from_eye;   // 1: offsets from the eye
uniform vec4 root;        // the ground under the person, and a metre
uniform vec2 root_position;  // on the bed, 0 … 1
uniform vec2 turn;        // cosine and sine, anticlockwise from north

in vec3 part;
in vec3 part_normal;
in vec3 part_colour;
out vec4 leaf_colour;  // of life/standing.frag.glsl; light, where it tones that

void main() {
    vec3 position = root.xyz + root.w * vec3(rotated(part.xy, turn), part.z);
    vec3 normal = vec3(rotated(part_normal.xy, turn), part_normal.z);
    BedPoint ground = bed_point(textureLod(lighting_map, root_position, 0.0));
    if (clouds > 0.5 && from_eye > 0.5) ground.sun *= cloud_shade(position);
    vec3 to_eye = from_eye > 0.5 ? -normalize(position) : direction_to_eye(position);
    float direct = ground.sun * max(dot(normal, to_sun), 0.0);
    // Between the legs and under the arms less of the sky is seen.
    float open = mix(0.6, 1.0, smoothstep(0.2, 1.2, part.z));
    vec3 light = sun_light * direct + sky_light * (ground.sky * open * (0.5 + 0.5 * normal.z));
    const vec3 sand = vec3(0.40, 0.29, 0.18);  // throws some back
    light += sand * (sun_light * ground.sun * max(to_sun.z, 0.0) + sky_light) * (open * (0.5 - 0.5 * normal.z));
    vec3 radiance = part_colour * light;
    if (from_eye > 0.5) {
        vec3 haze = haze_along(position);
        radiance = mix(haze, radiance, air_left(length(position))) + glare(-to_eye);
    } else {
        radiance = with_haze(radiance, position, -to_eye);
    }
    leaf_colour = vec4(streamers > 0.5 ? radiance : display_from_linear(tone_curve(radiance)), 1.0);
    gl_Position = snapped(clip * vec4(position, 1.0));
}
