#version 330 core
// What surrounds the block: a pale plain under it, darkened where the block stands and shades it,
// fading into the haze, and the sky above. Written at the picture's own resolution, in 8 bits with one
// step of dither, so that its slow gradients do not band.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/noise.glsl"
#include "sky/sky.glsl"
#include "sky/disc.glsl"
#include "sky/stars.glsl"
#include "streamers/streamers.glsl"

uniform vec3 ray_origin;
uniform vec3 ray_right;    // origin or direction moves by these over the picture
uniform vec3 ray_up;
uniform vec3 ray_forward;
uniform float parallel;
uniform float base;        // height of the plain
uniform float clouds;      // 0: none
uniform sampler2D cloud_map;  // of background/clouds.frag.glsl
uniform vec2 cloud_corner;
uniform float endless;     // 1: no plain, as the ground reaches the horizon
uniform float near_disc2;  // angle around the sun within which its disc shows, squared
uniform float plain_alone; // 1: no ray comes near the horizon
uniform sampler2D floor_map;  // shares of sun and sky; see render/floor_map.h
uniform float floor_half_width;
uniform vec2 picture_pixels;
uniform float dithered;    // 1: for 8 bits
uniform vec2 tile_pixel;   // first pixel of this tile
uniform float tile_rows;
uniform vec2 first_drawn;  // its first pixel in the target, from below
uniform vec2 row_of;       // rows run downward: the first one's number, and 1 or, from the lowest on, −1

out vec4 colour;

vec3 plain(vec3 point, vec3 view) {
    vec2 at = point.xy / floor_half_width;
    vec2 light_shares = texture(floor_map, 0.5 * at + 0.5).rg;
    float beyond = smoothstep(0.8, 1.0, max(abs(at.x), abs(at.y)));
    light_shares = mix(light_shares, vec2(1.0), beyond);
    vec3 albedo = studio > 0.5 ? vec3(0.66, 0.657, 0.65) : vec3(0.80, 0.675, 0.515) * (1.0 + 0.025 * value_noise(point.xy * 2.1));
    vec3 light = albedo * (sun_light * max(to_sun.z, 0.0) * light_shares.x + sky_light * light_shares.y);
    // What the sky does not light near the block, the block's sunlit side does a little.
    light += albedo * albedo * 0.08 * sun_light * (1.0 - light_shares.y);
    // Far behind the block it ends in haze also where there is none around the block, without an edge against the sky.
    float depth = haze_depth(point);
    float behind = (1.0 - parallel) * max(depth - 1.0, 0.0);
    return mix(haze_towards(view), light, exp(min(haze_log * depth * depth, -0.05 * behind * behind)));
}

void main() {
    vec2 position_in_tile = vec2(gl_FragCoord.x, row_of.x + row_of.y * gl_FragCoord.y);
    vec2 at = (position_in_tile + tile_pixel) / picture_pixels;
    vec2 across = vec2(2.0, -2.0) * at + vec2(-1.0, 1.0);  // rows run downward
    vec3 offset = across.x * ray_right + across.y * ray_up;
    vec3 origin = ray_origin + parallel * offset;
    vec3 view = normalize(ray_forward + (1.0 - parallel) * offset);
    vec3 light;
    Disc disc = Disc(0.0, vec3(0.0));
    if (plain_alone > 0.5 || (view.z < -1e-4 && endless < 0.5)) {
        vec3 point = origin + view * ((base - origin.z) / view.z);
        light = plain(point, view);
    } else {
        float through = 1.0;
        light = sky(view);
        if (clouds > 0.5) {
            vec2 texel = 0.5 * (position_in_tile + tile_pixel) - cloud_corner;
            vec4 seen = texture(cloud_map, texel / vec2(textureSize(cloud_map, 0)));
            through = seen.a;
            light = seen.rgb + through * light;
        }
        if (atmosphere > 0.5) {
            light += glare(view);
            vec3 around = view - to_sun;
            // A loop of one round or none, since llvmpipe works out both sides of a condition.
            for (int near = 0; near < (dot(around, around) < near_disc2 ? 1 : 0); ++near) {
                float to_view = 1.0 / length(ray_forward + (1.0 - parallel) * offset);
                vec3 across_by = (1.0 - parallel) * to_view * (2.0 / picture_pixels.x) * ray_right;
                vec3 down_by = (1.0 - parallel) * to_view * (2.0 / picture_pixels.y) * ray_up;
                disc = sun_disc(view, across_by, down_by, through, stars > 0.5);
            }
        }
        if (stars > 0.5) light += through * (1.0 - disc.cover) * starlight(view);
    }
    disc.light += light;
    if (streamers > 0.5) {
        ivec2 visibility_at = ivec2(vec2(position_in_tile.x, tile_rows - position_in_tile.y) - first_drawn);
        light = through_streamers(light, visibility_at);
        disc.light = through_streamers(disc.light, visibility_at);
    }
    vec3 shown = tone_curve(light);
    if (atmosphere > 0.5 && plain_alone < 0.5) {
        for (int near = 0; near < (disc.cover > 0.0 ? 1 : 0); ++near) shown = mix(shown, tone_curve(disc.light), disc.cover);
    }
    ivec2 pixel = ivec2(position_in_tile + tile_pixel);
    float dither = hash(pixel) + hash(pixel + ivec2(7919, 104729)) - 1.0;
    colour = vec4(display_from_linear(shown) + dithered * dither / 255.0, 1.0);
}
