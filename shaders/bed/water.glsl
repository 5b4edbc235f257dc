// Water over the ground: how it flows, how its surface stands, and what it does to light. Needs
// common/light.glsl, sky/sky.glsl, bed/bed.glsl, bed/water_body.glsl and bed/soil.glsl before it.
uniform sampler2D ground_map;   // dampness of the ground, what was laid down on it (0 … 1 for −1 … 1), its palette place, water's cover
uniform sampler2D water_map;    // depth (m, below 0 on banks), velocity east and north (m/s), turbidity (0 clear … 1 muddy)
uniform sampler2D water_surface_map;  // slopes of the surface eastward and northward, that of the depth
uniform float clarity;         // depth at which the bed is half hidden, m
uniform float usual_froude;    // the median of the wet cells
uniform float closed_depth;    // from which water covers what stands out of the ground of a cell, m
uniform float metre;           // block lengths
uniform float steepening;      // of heights, as drawn

uniform sampler2D ring_map;    // rings of drops of rain: slopes of the surface around ½, and their mean square
uniform int ring_layers;       // of it, over each other; 0 where no rain falls
uniform float ring_tile_m;       // how long it is, block lengths
uniform vec2 ring_ends;        // of its slopes, and of their mean square
uniform float ring_mean;       // of the mean square, in parts of that end

const float gravity = 9.8;
const float shore_level = 1.0;
const float widest_ring = 0.3;  // m
const float still_speed = 0.05;  // m/s: about it waves lose the flow's direction, which a still point has none of

struct Water {
    float depth;     // m
    float film;      // 0 dry … 1 a closed surface
    float speed;     // m/s
    vec2 flow;       // its direction, shorter than 1 where it hardly moves
    float froude;
    vec2 slope;      // of its surface, as drawn
    float fall;      // how steep that is in truth
    float thin;      // 0 … 1: a film as drawn, that what stands out of the ground breaks
    float front;     // how steeply its depth changes
    float turbidity; // 0 clear … 1 muddy
    float ringed;    // how steep rings of drops are on it, in parts of those on ring_map
};

// A shore goes from cell to cell of the grid in steps: it is looked at over more than one.
vec3 ground_at(vec2 position, float level) { return textureLod(ground_map, position, max(level, shore_level)).rgb; }

// The mean of water's cover over about two pixels: else a pool that is as small is a speck.
float cover_at(vec2 position, float level) { return textureLod(ground_map, position, max(level, shore_level) + 1.0).a; }

// Below 0 on banks: a shore is where the depth is 0.
float depth_at(vec2 position, float level) { return max(textureLod(water_map, position, max(level, shore_level)).x, 0.0); }

Water water_at(vec2 position, float level) {
    vec4 texel = textureLod(water_map, position, max(level, shore_level));
    vec4 surface = textureLod(water_surface_map, position, max(level, shore_level));
    Water water;
    water.depth = max(texel.x, 0.0);
    water.speed = length(texel.yz);
    water.flow = texel.yz * inversesqrt(dot(texel.yz, texel.yz) + still_speed * still_speed);
    water.froude = water.speed / sqrt(gravity * max(water.depth, 1e-4 * clarity));
    water.slope = surface.xy;
    water.fall = length(surface.xy) / steepening;
    water.thin = 1.0 - smoothstep(1.0, 8.0, steepening * water.depth / closed_depth);
    water.front = surface.z;
    water.turbidity = texel.w;
    water.ringed = surface.w;
    water.film = 0.0;
    return water;
}

// What is known of the water at a place.
const float dry_water = 0.0;
const float thin_water = 1.0;
const float any_water = 2.0;

const float least_share = 0.1;  // of the depth that closes: below it hollows hold no more of it
const float thin_share = 3.0;   // up to it water holds neither foam nor clouds of silt
// Of the depth that closes: between them water begins to carry foam, which stays off shores.
const float floats_from = 6.0;
const float floats_at = 24.0;
const float dry_share = 0.21;   // below it not even the deepest hollow that bed/soil.glsl can make holds a closed film

// Ground that stands out breaks a thin sheet, and its hollows hold some more of it.
float closed_film(Water water, Soil soil) {
    float share = water.depth / closed_depth;
    float hollow = -0.45 * soil.height * smoothstep(least_share, 0.6, share) * (1.0 - smoothstep(1.5, 4.0, steepening * share));
    return smoothstep(0.004, 0.06, water.depth / clarity) * smoothstep(0.5, 1.7, share + hollow);
}

// How far a pixel is too wide to tell water from ground by their depths: it sees a mean of both, by their cover.
float by_cover(float width) { return smoothstep(0.10, 0.28, width / cell); }

// At least so deep is water that `cover` of a pixel holds: the mean of the depth there takes in banks, which are below 0.
float depth_by_cover(float depth, float cover) { return max(depth, 2.0 * closed_depth * smoothstep(0.0, 0.1, cover)); }

// The slope of small waves: crests across the flow where it is fast, next to none where it is still. Water of
// centimetres has low ones, and lines along the flow.
vec2 wave_slope(vec2 world, Water water, float width) {
    const float sheet = 0.06;  // m
    float long_waves = 2.3 * metre;
    vec2 gradient = 0.6 * shown_noise(world + 0.17, long_waves, width).yz;
    gradient += shown_noise(world.yx + 0.43, 0.31 * long_waves, width).zy;
    gradient += shown_noise(world + 0.83, 0.11 * long_waves, width).yz;
    gradient += 0.8 * shown_noise(world.yx + 0.61, 0.043 * long_waves, width).zy;
    vec2 across = vec2(-water.flow.y, water.flow.x);
    float strength = mix(0.26, 0.45, smoothstep(0.05, 1.1, water.froude));
    vec2 slope = strength * (gradient - 0.6 * dot(gradient, across) * across);
    float shallow = 1.0 - smoothstep(0.3 * sheet, sheet, water.depth);
    float lines = 0.0;
    for (int i = -1; i <= 1; ++i) {
        vec2 at = world + float(i) * 1.6 * long_waves * water.flow;
        lines += dot(shown_noise(at + 0.29, long_waves, width).yz, across);
    }
    return mix(slope, 0.15 * slope + 0.45 * strength * lines * across, shallow);
}

// Rings of drops: the slope of those that are wide enough to be seen, and the mean square slope of the others.
struct Rings {
    vec2 slope;
    float rough;
};

// None is seen on water that shoots, and but low ones on a film.
Rings drop_rings(vec2 world, Water water, float width) {
    Rings rings = Rings(vec2(0.0), 0.0);
    float height = water.ringed * (1.0 - 0.7 * water.thin) * (1.0 - smoothstep(0.6, 1.2, water.froude));
    float shown = detail_visibility(widest_ring * metre, width);  // else a pixel may see one or two of them, and sparkle
    if (shown > 0.0) {
        float level = log2(max(width * float(textureSize(ring_map, 0).x) / ring_tile_m, 1.0));
        for (int i = 0; i < ring_layers; ++i) {
            vec2 turn = i == 0 ? vec2(1.0, 0.0) : vec2(0.8, 0.6);
            vec2 at = vec2(turn.x * world.x - turn.y * world.y, turn.y * world.x + turn.x * world.y);
            vec3 texel = textureLod(ring_map, at / ring_tile_m + 0.37 * float(i), level).xyz;
            vec2 slope = ring_ends.x * shown * (2.0 * texel.xy - 1.0);
            rings.slope += vec2(turn.x * slope.x + turn.y * slope.y, turn.x * slope.y - turn.y * slope.x);
            rings.rough += max(ring_ends.y * mix(ring_mean, texel.z, shown) - dot(slope, slope), 0.0);
        }
    } else {
        rings.rough = float(ring_layers) * ring_ends.y * ring_mean;
    }
    return Rings(height * rings.slope, height * height * rings.rough);
}

// The normal of its surface, waves on it.
vec3 water_normal(vec2 world, Water water, Soil soil, vec2 rings, float width) {
    vec2 slope = water.slope;
    slope /= 1.0 + 1.2 * length(slope);  // an exaggerated surface, or a fall, does not mirror the zenith alone
    slope += (1.0 - 0.6 * water.thin) * wave_slope(world, water, width) + 0.7 * water.thin * soil.slope;  // a film wraps the ground
    slope += rings;
    return normalize(vec3(-slope, 1.0));
}

// −1 … 1: where muddy water carries more, in clouds drawn out along the flow. A film is too thin for them.
float silt_clouds(vec2 world, Water water) {
    float sum = 0.0;
    for (int i = -1; i <= 1; ++i)
        sum += 2.0 * texture(streak_map, (world + float(i) * 4.0 * metre * water.flow) / (noise_repeat * 7.0 * metre)).r - 1.0;
    vec2 across = vec2(-water.flow.y, water.flow.x);
    float swirls = 0.0;
    for (int i = 0; i < 2; ++i) {
        vec2 at = world.yx + 0.9 * sum * metre * across.yx + float(i) * 1.3 * metre * water.flow.yx;
        swirls += 2.0 * texture(streak_map, at / (noise_repeat * 1.7 * metre)).r - 1.0;
    }
    float wisps = 2.0 * texture(streak_map, (world + 0.5 * swirls * metre * across) / (noise_repeat * 0.55 * metre)).r - 1.0;
    return clamp(1.2 * sum + 0.55 * swirls + 0.22 * wisps, -1.2, 1.2) * smoothstep(thin_share, 8.0, water.depth / closed_depth);
}

// Bubbles and litter that muddy water carries, in broken lines along the flow. `silt`: of its clouds, which meet there.
float foam_lines(vec2 world, Water water, float silt, float width) {
    float sum = 0.0;
    for (int i = -2; i <= 2; ++i)
        sum += 2.0 * texture(streak_map, (world.yx + float(i) * 1.1 * metre * water.flow.yx) / (noise_repeat * 0.8 * metre)).r - 1.0;
    float lace = 2.0 * texture(streak_map, world / (noise_repeat * 0.16 * metre)).r - 1.0;
    float bubbles = shown_noise(world + 0.47, 0.07 * metre, width).x;
    float line = smoothstep(1.15, 2.3, sum + 0.5 * silt + 0.75 * detail_visibility(0.16 * metre, width) * lace + 0.75 * bubbles);
    return 0.55 * water.turbidity * line * smoothstep(0.05, 0.25, water.speed) * smoothstep(floats_from, floats_at, water.depth / closed_depth);
}

// White water where it shoots, most where it is rougher than usual or deepens at once: at fronts and jumps, in patches
// drawn out along the flow and laced with holes. A film is too thin to hold air.
float foam_cover(vec2 world, Water water, float width) {
    float shooting = smoothstep(0.9, 1.3, water.froude);
    float deep = smoothstep(0.01, 0.12, water.depth / clarity) * smoothstep(floats_from, floats_at, water.depth / closed_depth);
    float rougher = smoothstep(1.15, 1.9, water.froude / max(usual_froude, 0.9));
    float stirred = max(0.55 * rougher, smoothstep(0.05, 0.30, water.front));
    vec2 stride = water.flow * (0.8 * metre);
    float patches = 0.0;
    float lace = 0.0;
    for (int i = 0; i < 5; ++i) {
        vec2 at = world + (float(i) - 2.0) * stride;
        patches += 2.0 * texture(streak_map, at / (noise_repeat * 1.5 * metre)).r - 1.0;
        lace += 2.0 * texture(streak_map, at.yx / (noise_repeat * 0.42 * metre)).r - 1.0;
    }
    float bubbles = shown_noise(world + 0.19, 0.13 * metre, width).x;
    float pattern = 0.5 + 0.26 * patches + detail_visibility(0.42 * metre, width) * 0.30 * lace + 0.35 * bubbles;
    float density = shooting * deep * stirred;
    return 0.95 * sqrt(density) * smoothstep(0.80 - density, 1.50 - density, pattern);
}
