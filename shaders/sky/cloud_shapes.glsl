// Where clouds are, by whole-number hashes: the same on every machine. Lengths in km, z from the ground, of clouds from
// their base. Needs common/light.glsl before it.
uniform float clouds;          // 0: none, 1: cumulus, 2: cirrus
uniform float cloud_threshold; // of noise: there is cloud above it
uniform float cloud_base;
uniform vec2 cloud_eye;        // the eye's place
uniform float kilometres;      // of a block length
uniform vec2 cloud_shift;      // how far they have drifted, subtracted from places
uniform vec2 cloud_wind;       // where that blows to, unit vector
uniform int cloud_seed;

const float curve = 1.0 / (2.0 * 6360.0);  // of the Earth
const float cumulus_thickness = 1.25;
const float cumulus_extinction = 26.0;     // per km

// How far it is along a ray of a direction's z to where it is so much higher.
float along_to(float up, float rise) {
    float bend = curve * (1.0 - up * up);
    float root = sqrt(max(up * up + 4.0 * bend * rise, 0.0));
    return rise <= 0.0 ? 0.0 : 2.0 * rise / max(up + root, 1e-5);
}

float cloud_hash(uint h) {
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 13;
    h *= 0x297a2d39u;
    return float(int(h >> 16)) * (1.0 / 65535.0);
}

uint cell_number(ivec2 cell) { return uint(cell.x) * 0x8da6b343u + uint(cell.y) * 0xd8163841u + uint(cloud_seed) * 0x9e3779b9u; }

// −1 … 1, smooth, one feature to a unit of length.
float cloud_noise(vec2 p) {
    vec2 whole = floor(p);
    vec2 t = p - whole;
    t = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    uint n = cell_number(ivec2(whole));
    float south = mix(cloud_hash(n), cloud_hash(n + 0x8da6b343u), t.x);
    float north = mix(cloud_hash(n + 0xd8163841u), cloud_hash(n + 0xd8163841u + 0x8da6b343u), t.x);
    return 2.0 * mix(south, north, t.y) - 1.0;
}

float cloud_noise(vec3 p) {
    const uint higher = 0xcb1ab31fu;
    vec3 whole = floor(p);
    vec3 t = p - whole;
    t = t * t * (3.0 - 2.0 * t);
    uint n = cell_number(ivec2(whole.xy)) + uint(int(whole.z)) * higher;
    const uint x = 0x8da6b343u;
    const uint y = 0xd8163841u;
    float low = mix(mix(cloud_hash(n), cloud_hash(n + x), t.x), mix(cloud_hash(n + y), cloud_hash(n + y + x), t.x), t.y);
    n += higher;
    float high = mix(mix(cloud_hash(n), cloud_hash(n + x), t.x), mix(cloud_hash(n + y), cloud_hash(n + y + x), t.x), t.y);
    return 2.0 * mix(low, high, t.z) - 1.0;
}

const mat2 turned_a = mat2(0.8, 0.6, -0.6, 0.8);
const mat2 turned_b = mat2(0.28, 0.96, -0.96, 0.28);

// What cumulus clouds grow from: cells of rising air of unequal size, in groups. Its standard deviation is 0.3.
float cumulus_field(vec2 position) {
    vec2 p = position - cloud_shift;
    return 0.35 * cloud_noise(p * (1.0 / 11.0) + 3.7) + 0.50 * cloud_noise(turned_b * p * (1.0 / 2.3)) +
           0.30 * cloud_noise(turned_a * p * (1.0 / 1.02) + 17.3) + 0.17 * cloud_noise(p * (1.0 / 0.46) + 5.1);
}

// Above 0 within a cloud without its bulges.
float cumulus_outline(vec2 position, float height) {
    float up = max(height, 0.0) / cumulus_thickness;
    return 1.7 * (cumulus_field(position) - cloud_threshold) - 1.15 * up * sqrt(up);
}

// How strong bulges are, and the most that they add.
float cumulus_bulge(float height) { return 0.22 + 0.25 * clamp(height / 0.40, 0.0, 1.0); }
const float farthest_bulge = 0.12;
float cumulus_most_bulge(float height) { return min(0.45 * cumulus_bulge(height), farthest_bulge); }

// Heads like cauliflowers: round between sharp creases. Those finer than `finest` are left out. Away from the outline they
// add little, as else the highest would float over the rest.
float cumulus_bulges(vec3 at, float outline, float finest, int octaves) {
    vec3 p = vec3(at.xy - cloud_shift, 1.25 * at.z) * (1.0 / 0.40);
    float size = 0.40;
    float weight = 0.52;
    float sum = 0.0;
    for (int i = 0; i < octaves && size > finest; ++i) {
        sum += weight * min(size / finest - 1.0, 1.0) * (abs(cloud_noise(p)) * 2.0 - 0.8);
        p = vec3(turned_a * p.xy, p.z).zxy * 2.17 + 11.3;
        size *= 1.0 / 2.17;
        weight *= 0.54;
    }
    return cumulus_bulge(at.z) * (sum > 0.0 ? 0.5 * sum * clamp(1.0 + outline / farthest_bulge, 0.0, 1.0) : sum);
}

float cumulus_density(float inside, float height) {
    return clamp(inside * (1.0 / 0.07), 0.0, 1.0) * smoothstep(0.0, 0.11, height);
}

// Optical depth of combed-out ice straight down.
float cirrus_depth(vec2 position, float finest) {
    vec2 p = position - cloud_shift;
    vec2 flow = vec2(dot(p, cloud_wind), dot(p, vec2(-cloud_wind.y, cloud_wind.x)));
    // Winds of other strength comb it aslant and bend it.
    flow.y += 2.6 * cloud_noise(flow * vec2(1.0 / 26.0, 1.0 / 17.0)) + 0.9 * cloud_noise(flow * vec2(1.0 / 8.0, 1.0 / 6.0) + 9.1);
    float patches = 0.62 * cloud_noise(flow * vec2(1.0 / 34.0, 1.0 / 15.0) + 4.4) + 0.38 * cloud_noise(turned_a * flow * (1.0 / 9.0));
    float thick = smoothstep(-0.35, 0.75, patches - 1.1 * cloud_threshold);
    float threads = 0.0;
    float weight = 0.5;
    vec2 q = flow * vec2(1.0 / 9.0, 1.0 / 1.5);
    float width = 1.5;
    for (int i = 0; i < 6 && width > finest; ++i) {
        threads += weight * min(width / finest - 1.0, 1.0) * cloud_noise(q);
        q = q * vec2(1.75, 2.1) + vec2(7.7, 3.1) + 0.35 * threads;
        width *= 1.0 / 2.1;
        weight *= 0.68;
    }
    float fibre = clamp(0.5 + 0.75 * threads, 0.0, 1.4);
    return 0.62 * thick * (0.10 + fibre * fibre) * smoothstep(0.05, 0.5, thick + 0.4 * threads);
}

// Share of the sun's light that passes to a place of the ground, by its offset from the eye, block lengths: what the
// outlines of the clouds before the sun leave of it, and what they let through.
float cloud_shade(vec3 from_eye) {
    vec2 position = cloud_eye + kilometres * from_eye.xy;
    vec2 way = to_sun.xy / max(to_sun.z, 0.02);
    if (clouds > 1.5) return exp(-0.8 * cirrus_depth(position + cloud_base * way, 0.1));
    float depth = 0.0;
    for (int i = 0; i < 2; ++i) {
        float height = i == 0 ? 0.08 : 0.34;
        float outline = cumulus_outline(position + (cloud_base + height) * way, height);
        depth += max(outline - 0.03, 0.0);
    }
    return 0.14 + 0.86 * exp(-22.0 * depth);
}
