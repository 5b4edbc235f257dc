// Water over the ground: how it flows, how its surface stands, and what it does to light. Needs
// common/light.glsl, sky/sky.glsl, bed/bed.glsl and bed/water_body.glsl before it.
uniform sampler2D water_map;   // depth (m), velocity east and north (m/s), dampness of the ground
uniform sampler2D water_slope_map;  // by which depth adds to the bed's slope, in block lengths
uniform sampler2D streak_map;  // seamless: noise, and its slopes east and north around ½
uniform float clarity;         // depth at which the bed is half hidden, m
uniform float usual_froude;    // the median of the wet cells
uniform float closed_depth;    // from which water covers what stands out of the ground of a cell, m

const float gravity = 9.8;

struct Water {
    float depth;     // m
    float damp;      // of the ground, 0 … 1
    float film;      // 0 dry … 1 a closed surface
    float speed;     // m/s
    vec2 flow;       // unit vector, or 0 at rest
    float froude;
};

Water water_at(vec2 place) {
    vec4 texel = texture(water_map, place);
    Water water;
    water.depth = texel.x;
    water.damp = texel.w;
    water.film = smoothstep(0.004, 0.06, water.depth / clarity) * smoothstep(0.25, 1.0, water.depth / closed_depth);
    water.speed = length(texel.yz);
    water.flow = texel.yz / max(water.speed, 1e-6);
    water.froude = water.speed / sqrt(gravity * max(water.depth, 1e-4 * clarity));
    return water;
}

// −1 … 1: noise drawn out along the flow (line integral convolution over a straight piece of
// stream line), repeated `fineness` times over the block.
float streaks(vec2 world, vec2 flow, float fineness) {
    vec2 stride = flow * (1.7 / 512.0);
    vec2 start = world * fineness;
    float sum = 0.0;
    for (int i = -3; i <= 3; ++i) sum += texture(streak_map, start + float(i) * stride).r;
    return clamp((sum / 7.0 - 0.5) * 7.5, -1.0, 1.0);
}

// The slope of small waves: crests across the flow where it is fast, none where it is still.
vec2 ripple_slope(vec2 world, Water water) {
    vec2 across = vec2(-water.flow.y, water.flow.x);
    vec2 gradient = 2.0 * texture(streak_map, world * 0.35).gb - 1.0;
    gradient += 1.2 * (2.0 * texture(streak_map, world.yx * 1.3 + 0.31).bg - 1.0);
    float strength = mix(0.03, 0.14, smoothstep(0.02, 0.6, water.froude)) * water.film;
    return strength * (gradient - 0.6 * dot(gradient, across) * across);
}

// The normal of bed plus depth, ripples on it.
vec3 water_normal(vec2 place, vec2 world, BedPoint bed, Water water) {
    vec2 slope = -bed.normal.xy / max(bed.normal.z, 0.05);
    slope += texture(water_slope_map, place).xy;
    slope /= 1.0 + 0.5 * length(slope);  // an exaggerated surface does not mirror only the horizon
    slope += ripple_slope(world, water);
    return normalize(vec3(-slope, 1.0));
}
