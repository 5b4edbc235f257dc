#version 330 core
// What a puff adds to a pixel: its optical depth up to the ground, alone and times its radiance. Sums of these do not
// depend on the order.
uniform vec3 right;
uniform vec3 up;
uniform vec3 ahead;  // to the picture's middle
uniform vec3 aside;  // of the eye, of the point that sees
uniform vec2 lens;
uniform vec2 tile_pixel;      // the tile's lower left pixel in the picture
uniform vec2 picture_pixels;
uniform sampler2D ground_map;  // of streamers/depths.frag.glsl
uniform sampler2D noise_map;   // of streamers/streaks.frag.glsl
uniform float noise_scale;     // of its side, a feature
uniform vec2 wind;       // where it blows to
uniform vec3 eye_position;  // downwind of what moves with the wind, across the wind, up; metres
uniform float metre;

flat in vec3 to_unit_x;
flat in vec3 to_unit_y;
flat in vec3 to_unit_z;
flat in vec3 unit_middle;
flat in vec4 scattered;
out vec4 depths;

// The share of a normal law below a place, nearly.
vec4 below(vec4 position) { return smoothstep(-2.0, 2.0, position); }

// How much denser or thinner the air's turbulence makes it at a place: long streaks that move with the wind.
float streaks(vec3 offset) {
    vec3 at = eye_position + vec3(dot(offset.xy, wind), dot(offset.xy, vec2(-wind.y, wind.x)), offset.z) / metre;
    float level = texture(noise_map, noise_scale * vec2(at.x / 3.1, at.y / 0.24)).x;
    float upright = texture(noise_map, noise_scale * vec2(at.x / 3.4 + 5.7, (at.z + 0.06 * at.x) / 0.19)).y;
    float sum = clamp(level + 0.8 * upright - 0.3, 0.0, 1.5);
    return 0.4 + 1.3 * sum * sum;
}

void main() {
    vec2 at = 2.0 * (gl_FragCoord.xy + tile_pixel) / picture_pixels - 1.0;
    vec3 ray = ahead + at.x * right + at.y * up;
    vec3 way = vec3(dot(to_unit_x, ray), dot(to_unit_y, ray), dot(to_unit_z, ray));
    float length2 = dot(way, way);
    float nearest = dot(way, unit_middle) / length2;
    vec3 off = unit_middle - nearest * way;
    // A normal law that ends where the puff's square does: on its edge, rounding would put pixels in or out.
    float distance2 = dot(off, off);
    float density = 1.058 * exp(-0.5 * distance2) * (1.0 - smoothstep(4.5, 7.3, distance2));
    vec4 ground = texelFetch(ground_map, ivec2(gl_FragCoord.xy), 0);
    float before = dot(below((ground - nearest) * sqrt(length2)), vec4(0.25));
    float depth = scattered.w * 2.5066283 * inversesqrt(length2) * length(ray) * density * before * streaks(nearest * ray + aside);
    depths = vec4(scattered.rgb * depth, depth);
}
