// How far copies of a bed that repeats are made unlike each other: TileWarp of render/view/tile_warp.h, with its waves.
// Needs bed/bed.glsl before it.
uniform float varied;          // 1: they are
uniform vec2 eye_from_middle;  // of what is as it is, periods
uniform float warp_strength;   // 0 … 1: how much of it

struct WarpedGround {
    vec2 offset;  // to where ground is taken from, periods
    mat2 jacobian;  // how that place moves on, of a way over the ground; periods
    float height; // of the bed's, counted from its mean
    vec2 height_gradient;  // how that changes on the way, per period
};
const WarpedGround unwarped = WarpedGround(vec2(0.0), mat2(1.0), 1.0, vec2(0.0));

// A number and its slopes.
vec3 product(vec3 a, vec3 b) { return vec3(a.x * b.x, a.x * b.yz + b.x * a.yz); }

// 0 where ground is as it is … 1 from `width` farther on.
vec3 warp_fade(vec2 from_middle, float range, float width) {
    const float unwarped = 0.7;
    float t = clamp((range - unwarped) / width, 0.0, 1.0);
    return warp_strength * vec3(t * t * (3.0 - 2.0 * t), from_middle * (6.0 / width * t * (1.0 - t) / max(range, unwarped)));
}

// Parabolas between −1 and 1, and their slopes.
vec3 warp_wave(vec2 wave, float turns) {
    float across = 2.0 * fract(turns) - 1.0;
    float inward = 1.0 - abs(across);
    return vec3(4.0 * across * inward, wave * (16.0 * inward - 8.0));
}

void add_wave(vec2 from_middle, vec2 wave, float begin, vec2 aside, float lower, inout vec3 east, inout vec3 north, inout vec3 lowered) {
    float turns = dot(wave, from_middle) + begin;
    vec3 at = warp_wave(wave, turns);
    east += aside.x * at;
    north += aside.y * at;
    lowered += lower * warp_wave(wave, turns + 0.25);
}

// At an offset from the eye, block lengths.
WarpedGround warped_ground(vec2 offset) {
    if (varied < 0.5) return unwarped;
    vec2 p = eye_from_middle + offset / extent;
    vec3 near_east = vec3(0.0);
    vec3 near_north = vec3(0.0);
    vec3 far_east = vec3(0.0);
    vec3 far_north = vec3(0.0);
    vec3 lowered = vec3(0.33, 0.0, 0.0);
    add_wave(p, vec2(0.149, 0.350), 0.13, vec2(0.031, 0.074), 0.10, near_east, near_north, lowered);
    add_wave(p, vec2(0.335, -0.065), 0.57, vec2(0.088, -0.017), 0.10, near_east, near_north, lowered);
    add_wave(p, vec2(0.257, -0.482), 0.31, vec2(0.040, -0.033), 0.09, near_east, near_north, lowered);
    add_wave(p, vec2(0.097, 0.034), 0.21, vec2(0.081, -0.236), 0.0, far_east, far_north, lowered);
    add_wave(p, vec2(-0.028, 0.070), 0.77, vec2(0.287, 0.116), 0.0, far_east, far_north, lowered);
    float range = length(p);
    vec3 near = warp_fade(p, range, 1.0);
    vec3 far = warp_fade(p, range, 4.0);
    vec3 east = product(near, near_east) + product(far, far_east);
    vec3 north = product(near, near_north) + product(far, far_north);
    vec3 low = product(warp_fade(p, range, 0.4), lowered);
    return WarpedGround(vec2(east.x, north.x), mat2(1.0 + east.y, north.y, east.z, 1.0 + north.z), 1.0 - low.x, -low.yz);
}

// The slope of ground that stands at `z` over the bed's mean, of the bed's there; block lengths.
vec2 warped_slope(WarpedGround copy, vec2 on_bed, float z) {
    return (copy.height * ((on_bed * extent) * copy.jacobian) + z / max(copy.height, 0.1) * copy.height_gradient) / extent;
}
