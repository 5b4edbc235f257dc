// Smooth noise from whole-number hashes: the same on every machine.

uint hash_bits(ivec2 cell) {
    uint h = uint(cell.x) * 0x8da6b343u + uint(cell.y) * 0xd8163841u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

float hash(ivec2 cell) { return float(hash_bits(cell) & 0xffffu) / 65535.0; }

// Both parts −1 … 1.
vec2 hash_vector(ivec2 cell) {
    uint h = hash_bits(cell);
    return vec2(h & 0xffffu, h >> 16) / 32767.5 - 1.0;
}

// −1 … 1, smooth, one feature to a unit of length.
float value_noise(vec2 p) {
    vec2 whole = floor(p);
    vec2 t = p - whole;
    t = t * t * (3.0 - 2.0 * t);
    ivec2 cell = ivec2(whole);
    float south = mix(hash(cell), hash(cell + ivec2(1, 0)), t.x);
    float north = mix(hash(cell + ivec2(0, 1)), hash(cell + ivec2(1, 1)), t.x);
    return 2.0 * mix(south, north, t.y) - 1.0;
}

// The same, and its slope along x and y.
vec3 sloped_noise(vec2 p) {
    vec2 whole = floor(p);
    vec2 t = p - whole;
    vec2 rise = 6.0 * t * (1.0 - t);
    t = t * t * (3.0 - 2.0 * t);
    ivec2 cell = ivec2(whole);
    float south_west = hash(cell);
    float east = hash(cell + ivec2(1, 0)) - south_west;
    float north = hash(cell + ivec2(0, 1)) - south_west;
    float twist = hash(cell + ivec2(1, 1)) - south_west - east - north;
    return 2.0 * vec3(south_west + east * t.x + north * t.y + twist * t.x * t.y - 0.5,
                      rise * vec2(east + twist * t.y, north + twist * t.x));
}

// Between −1 and 1, 0 at whole numbers, with slopes of its own there and along no axis more than along another; and its slope.
vec3 sloped_gradient_noise(vec2 p) {
    vec2 whole = floor(p);
    vec2 t = p - whole;
    vec2 rise = 30.0 * t * t * (t - 1.0) * (t - 1.0);
    vec2 s = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    ivec2 cell = ivec2(whole);
    vec2 sw = hash_vector(cell);
    vec2 se = hash_vector(cell + ivec2(1, 0));
    vec2 nw = hash_vector(cell + ivec2(0, 1));
    vec2 ne = hash_vector(cell + ivec2(1, 1));
    float at_sw = dot(sw, t);
    float east = dot(se, t - vec2(1.0, 0.0)) - at_sw;
    float north = dot(nw, t - vec2(0.0, 1.0)) - at_sw;
    float twist = dot(ne, t - 1.0) - at_sw - east - north;
    vec2 slope = mix(mix(sw, se, s.x), mix(nw, ne, s.x), s.y) + rise * vec2(east + twist * s.y, north + twist * s.x);
    return 1.4 * vec3(at_sw + east * s.x + north * s.y + twist * s.x * s.y, slope);
}

// As value_noise(), with a whole number of features to each period of p.
float periodic_noise(vec2 p, ivec2 period) {
    vec2 whole = floor(p);
    vec2 t = p - whole;
    t = t * t * (3.0 - 2.0 * t);
    ivec2 here = ivec2(mod(whole, vec2(period)));
    ivec2 next = ivec2(mod(whole + 1.0, vec2(period)));
    float south = mix(hash(here), hash(ivec2(next.x, here.y)), t.x);
    float north = mix(hash(ivec2(here.x, next.y)), hash(next), t.x);
    return 2.0 * mix(south, north, t.y) - 1.0;
}
