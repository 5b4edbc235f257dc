// Water over the ground: how it flows, how its surface stands, and what it does to light. Needs
// light.glsl, noise.glsl, sky.glsl, bed.glsl and water_body.glsl before it.
uniform sampler2D water_map;   // depth (m), velocity east and north (m/s), dampness of the ground
uniform sampler2D streak_map;  // seamless noise
uniform vec2 water_cell;       // extent of one of its texels, 0 … 1
uniform float water_rise;      // block lengths of a metre of depth
uniform float clarity;         // depth at which the bed is half hidden, m
uniform float usual_froude;    // the median of the wet cells

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
    water.film = smoothstep(0.004, 0.06, water.depth / clarity);
    water.speed = length(texel.yz);
    water.flow = texel.yz / max(water.speed, 1e-6);
    water.froude = water.speed / sqrt(gravity * max(water.depth, 1e-4 * clarity));
    return water;
}

// −1 … 1: noise drawn out along the flow, `fineness` times across the block.
float streaks(vec2 world, vec2 flow, float fineness, float reach) {
    vec2 start = world * fineness;
    vec2 stride = flow * (reach / 4.0);
    float sum = 0.0;
    for (int i = -4; i <= 4; ++i) sum += texture(streak_map, start + float(i) * stride).r;
    return clamp((sum / 9.0 - 0.5) * 7.0, -1.0, 1.0);
}

// The slope of small waves: crests across the flow where it is fast, none where it is still.
vec2 ripple_slope(vec2 world, Water water) {
    vec2 across = vec2(-water.flow.y, water.flow.x);
    const float apart = 0.0012;
    float here = value_noise(world * 170.0);
    vec2 gradient = vec2(value_noise((world + vec2(apart, 0.0)) * 170.0) - here,
                         value_noise((world + vec2(0.0, apart)) * 170.0) - here) / (apart * 170.0);
    float strength = 0.10 * smoothstep(0.02, 0.5, water.froude) * water.film;
    return strength * (gradient - 0.6 * dot(gradient, across) * across);
}

// The normal of bed plus depth, ripples on it.
vec3 water_normal(vec2 place, vec2 world, BedPoint bed, Water water) {
    vec2 slope = -bed.normal.xy / max(bed.normal.z, 0.05);
    float east = texture(water_map, place + vec2(water_cell.x, 0.0)).x;
    float west = texture(water_map, place - vec2(water_cell.x, 0.0)).x;
    float north = texture(water_map, place + vec2(0.0, water_cell.y)).x;
    float south = texture(water_map, place - vec2(0.0, water_cell.y)).x;
    slope += water_rise * vec2(east - west, north - south) / (2.0 * water_cell * extent);
    slope += ripple_slope(world, water);
    return normalize(vec3(-slope, 1.0));
}

// What is left of light after a way through the water (Beer–Lambert), in units of `clarity`: clear
// water takes the red first, silt the blue.
vec3 transmitted(float way) {
    vec3 absorbed = mix(vec3(1.75, 0.62, 0.50), vec3(0.62, 0.85, 1.45), turbidity);
    return exp(-0.693 * way * absorbed);
}
