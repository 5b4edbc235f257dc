#version 330 core
// The ground around the camera: a fan of rays and rings over it, raised by the periodic bed and lowered
// by the planet's curvature.
#include "snap.glsl"

uniform mat4 clip_from_eye;  // without the eye's place, which stands in `eye`
uniform vec3 eye;            // block lengths; x and y reduced to one period
uniform vec2 heading;        // of the fan's middle, unit vector
uniform float half_angle;    // of the fan, radians
uniform float nearest;       // radius of the innermost ring, block lengths
uniform float reach;         // log of the outermost ring's radius over that
uniform float ray_spacing;   // at distance 1
uniform float ring_spacing;  // the same, on the whole
uniform vec2 extent;
uniform float cell;          // of the bed, block lengths
uniform float curvature;     // 1 / (2 R), per block length
uniform sampler2D height_map;

in vec2 ray_and_ring;  // −1 … 1, and 0 … 1; below 0: the point under the eye
out vec3 at_sample;    // the offset from the eye

void main() {
    float angle = ray_and_ring.x * half_angle;
    float radius = ray_and_ring.y < 0.0 ? 0.0 : nearest * exp(reach * ray_and_ring.y * (0.6 + 0.4 * ray_and_ring.y));  // closer at first
    vec2 along = radius * vec2(heading.x * cos(angle) - heading.y * sin(angle), heading.x * sin(angle) + heading.y * cos(angle));
    vec2 place = (eye.xy + along) / extent + 0.5;
    float spacing = max(ray_spacing, ring_spacing * (0.6 + 0.8 * max(ray_and_ring.y, 0.0)));
    // Finer than between vertices, so that it matters little where the texels lie.
    float level = max(log2(radius * spacing / cell) - 3.5, 0.0);
    float height = textureLod(height_map, place, level).r;
    at_sample = vec3(along, height - radius * radius * curvature - eye.z);
    gl_Position = snapped(clip_from_eye * vec4(at_sample, 1.0));
}
