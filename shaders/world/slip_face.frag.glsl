#version 330 core
// A slip face up close, made once and repeated: tongues of sand that slid down it. Of each the head is a shallow scar, the
// lower end a lobe that stands out with steep edges; younger ones lie over older ones. Slopes across the face and up it, and
// how much lighter it is, each 0 … 1 for −0.4 … 0.4 or −1 … 1. Lengths in metres.
#include "common/noise.glsl"

uniform vec2 size;    // across the face, and up it
uniform vec2 texels;  // along both sides

in vec2 position;
out vec4 face;

const int salts = 4;

float random_of(ivec2 tongue, int salt) { return hash(salts * tongue + ivec2(salt, 7919 * salt)); }

// Its height over the face and its lightness, and how far it covers what lies below.
vec3 tongue(vec2 at, ivec2 cell, ivec2 count, float widest) {
    vec2 pitch = size / vec2(count);
    ivec2 own = (cell % count + count) % count + 1000 * count;
    float a = random_of(own, 0);
    float b = random_of(own, 1);
    float c = random_of(own, 2);
    float d = random_of(own, 3);
    float half_width = widest * mix(0.4, 1.0, a * a);
    float length_up = pitch.y * mix(0.35, 0.95, b);
    float up = at.y - (float(cell.y) + c) * pitch.y;
    float share = up / length_up;
    float middle = (float(cell.x) + 0.5 + 0.7 * (d - 0.5)) * pitch.x;
    float aside = (at.x - middle) / (half_width * mix(1.0, 0.5, clamp(share, 0.0, 1.0)));
    float nose = max(1.0 - up / (mix(1.5, 4.0, c) * half_width), 0.0);
    float inside = 1.0 - aside * aside - nose * nose;
    float cover = smoothstep(0.0, 1.0, inside) * (1.0 - smoothstep(0.3, 1.0, share));
    float thick = 0.010 * half_width * (1.0 - smoothstep(0.0, 0.9, share));
    float light = mix(-0.25, 0.9, fract(7.3 * a + 3.1 * c)) * (1.0 - 0.5 * share);
    return vec3(thick, light, cover);
}

// Of tongues of one size, in cells of as many; no tongue is longer than its cell.
vec2 tongues(vec2 at, ivec2 count, float widest) {
    ivec2 own = ivec2(floor(at / size * vec2(count)));
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 0; ++j) {
        for (int i = -1; i <= 1; ++i) {
            vec3 over = tongue(at, own + ivec2(i, j), count, widest);
            sum = mix(sum, over.xy, over.z);
        }
    }
    return sum;
}

vec2 face_at(vec2 at) {
    // Edges fray.
    vec2 frayed = at + vec2(0.05 * periodic_noise(at / size * vec2(40.0, 60.0), ivec2(40, 60)) + 0.02 * periodic_noise(at / size * vec2(110.0, 150.0), ivec2(110, 150)), 0.0);
    vec2 wide = tongues(frayed, ivec2(11, 3), 0.60);
    vec2 narrow = tongues(frayed, ivec2(27, 5), 0.22);
    vec2 thin = tongues(frayed, ivec2(61, 11), 0.08);
    // Grains roll down in threads.
    vec2 threads = size * vec2(7.0, 0.4);
    float thread = periodic_noise(at / size * threads, ivec2(threads)) + 0.6 * periodic_noise(2.0 * at / size * threads + 0.3, 2 * ivec2(threads));
    return wide + 0.8 * narrow + 0.7 * thin + thread * vec2(0.0018, 0.30);
}

void main() {
    vec2 here = face_at(position * size);
    vec2 slope = vec2(dFdx(here.x), dFdy(here.x)) * texels / size;
    face = vec4(0.5 + 1.25 * slope, 0.5 + 0.5 * here.y, 1.0);
}
