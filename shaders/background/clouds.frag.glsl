#version 330 core
// Clouds alone, at half the picture's resolution: the light that they send, and the share of the sky's that passes. Texels lie
// among the picture's pixels alike in any tile.
#include "common/light.glsl"
#include "sky/clouds.glsl"

uniform vec3 ray_origin;
uniform vec3 ray_right;
uniform vec3 ray_up;
uniform vec3 ray_forward;
uniform float parallel;
uniform float base;         // height of the plain
uniform vec2 picture_pixels;
uniform vec2 cloud_corner;  // the first texel's number, of those of two pixels each from the picture's upper left

out vec4 cloud_light;

void main() {
    vec2 at = 2.0 * (gl_FragCoord.xy + cloud_corner) / picture_pixels;
    vec2 across = vec2(2.0, -2.0) * at + vec2(-1.0, 1.0);
    vec3 offset = across.x * ray_right + across.y * ray_up;
    vec3 origin = ray_origin + parallel * offset;
    vec3 view = normalize(ray_forward + (1.0 - parallel) * offset);
    CloudLight seen = CloudLight(vec3(0.0), 1.0);
    for (int i = 0; i < (view.z > lowest_cloud ? 1 : 0); ++i)
        seen = march_clouds(kilometres * (origin - vec3(0.0, 0.0, base)), view, scattered_sky(view));
    cloud_light = vec4(seen.light, seen.through);
}
