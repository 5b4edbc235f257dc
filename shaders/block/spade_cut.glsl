// Soil as a spade cuts it: crumbs of all sizes, sand that is damp below its dry skin, or earth with stones. Needs
// common/noise.glsl before it. Lengths are block lengths.
uniform float pixels;  // to a block length, at its middle: what is finer is left out
uniform vec3 sand_crest;
uniform vec3 sand_trough;

struct Cut {
    vec3 albedo;
    vec2 slope;  // of its surface, along the face and upward
};

float shown(float features) { return 1.0 - smoothstep(0.25, 0.6, features / pixels); }

// Height −1 … 1 and slope of the crumbs.
vec3 crumbs(vec2 at, float features) {
    vec3 sum = vec3(0.0);
    float weight = 0.40;
    for (int octave = 0; octave < 4; ++octave) {
        vec3 noise = sloped_noise(at * features + 31.0 * float(octave));
        sum += weight * shown(features) * vec3(noise.x, 0.45 * noise.yz);
        features *= 2.17;
        weight *= 0.62;
    }
    return sum;
}

// One stone in most squares of a lattice: whether it is met, its tone and the slope of its surface.
vec4 stone(vec2 at, float squares, float share) {
    vec2 scaled = at * squares;
    ivec2 square = ivec2(floor(scaled));
    vec2 centre = 0.5 + 0.2 * (vec2(hash(square), hash(square + ivec2(57, 13))) - 0.5);
    float radius = mix(0.16, 0.40, hash(square + ivec2(5, 91)));
    float flatness = mix(1.0, 1.9, hash(square + ivec2(71, 3)));
    vec2 off = (fract(scaled) - centre) * vec2(1.0, flatness) / radius;
    off += 0.25 * value_noise(scaled * 3.0);
    float away = dot(off, off);
    float met = step(hash(square + ivec2(29, 47)), share) * (1.0 - smoothstep(0.80, 1.0, away)) * shown(squares);
    return vec4(met, hash(square + ivec2(11, 7)), 0.9 * off);
}

vec3 dry_sand() {
    vec3 sand = mix(sand_trough, sand_crest, 0.5);
    return mix(vec3(dot(sand, vec3(0.2126, 0.7152, 0.0722))), sand, 0.66) * 1.04;
}

// Where water stands on it: less golden than a dune's.
vec3 silt() {
    vec3 sand = dry_sand();
    return mix(vec3(dot(sand, vec3(0.2126, 0.7152, 0.0722))), sand, 0.72);
}

const vec3 soaking = vec3(0.62, 0.575, 0.53);

// `depth`: below the ground; `silty`, 0 or 1: where water flows over it, it is level beds of silt, sand and grit into which
// the water has cut; `soaked`, 0 … 1: where water stands.
Cut sand_cut(vec2 at, float depth, float silty, float soaked) {
    vec3 crumb = crumbs(at, 110.0);
    float broad = value_noise(at * vec2(4.0, 9.0));
    float skin = 0.010 * (1.0 + 0.35 * value_noise(vec2(at.x * 9.0, 3.0)) + 0.35 * value_noise(vec2(at.x * 31.0, 9.0)));
    float dampness = smoothstep(0.55, 1.35, depth / skin + 0.35 * crumb.x);
    // Faint layers, broken here and there.
    float warp = at.y + 0.006 * value_noise(vec2(at.x * 3.1, 7.0)) + 0.0015 * value_noise(at * vec2(17.0, 60.0));
    float layers = shown(150.0) * value_noise(vec2(at.x * 2.0, warp * 150.0)) + 0.6 * shown(410.0) * value_noise(vec2(at.x * 3.7, warp * 410.0));
    float whole = smoothstep(-0.5, 0.6, value_noise(at * vec2(7.0, 19.0) + 40.0));
    float tone = 1.0 + 0.06 * broad + 0.13 * crumb.x + 0.10 * layers * whole;
    vec3 dry = dry_sand();
    Cut cut = Cut(mix(dry, dry * vec3(0.80, 0.755, 0.71), dampness) * tone,
                  0.30 * crumb.yz + vec2(0.10 * value_noise(vec2(at.x * 13.0, at.y * 2.0)), 0.0));

    float beds = 62.0 * warp + 0.9 * value_noise(vec2(3.0, warp * 21.0));
    ivec2 bed = ivec2(int(floor(beds)), 61);
    float sharp = clamp(124.0 / pixels, 0.06, 0.5);
    float next = smoothstep(1.0 - sharp, 1.0, beds - floor(beds));
    float shade = mix(hash(bed), hash(bed + ivec2(1, 0)), next);
    float coarse = mix(hash(bed + ivec2(0, 22)), hash(bed + ivec2(1, 22)), next);
    vec3 mud = silt();
    vec3 albedo = mud * mix(vec3(1.0), vec3(0.82, 0.775, 0.73), dampness);
    albedo = mix(albedo, mud * soaking, soaked * (1.0 - smoothstep(0.0, 0.05, depth)));
    albedo *= mix(vec3(0.74, 0.72, 0.71), vec3(1.20, 1.19, 1.16), smoothstep(0.05, 0.95, shade));
    albedo *= 1.0 + 0.06 * broad + (0.07 + 0.12 * coarse) * crumb.x + 0.10 * (1.0 - coarse) * layers;
    vec4 pebble = stone(at, 150.0, 0.22 * smoothstep(0.80, 0.95, coarse));
    vec3 grey = mix(vec3(0.22, 0.19, 0.16), vec3(0.46, 0.42, 0.36), pebble.y);
    Cut laid = Cut(mix(albedo, grey, pebble.x), mix((0.12 + 0.24 * coarse) * crumb.yz, -pebble.zw, pebble.x));
    return Cut(mix(cut.albedo, laid.albedo, silty), mix(cut.slope, laid.slope, silty));
}

Cut earth_cut(vec2 at, float depth) {
    vec3 crumb = crumbs(at, 61.0);
    float broad = value_noise(at * vec2(6.0, 14.0));
    float edge = 0.010 * (1.0 + 0.4 * value_noise(vec2(at.x * 8.0, 5.0)) + 0.3 * value_noise(vec2(at.x * 37.0, 2.0)));
    float below_roots = smoothstep(0.7, 1.5, depth / edge + 0.5 * crumb.x);
    float deep = smoothstep(0.02, 0.12, depth + 0.012 * broad);
    vec3 topsoil = vec3(0.215, 0.150, 0.098);
    vec3 subsoil = mix(vec3(0.345, 0.220, 0.125), vec3(0.400, 0.300, 0.205), deep);
    Cut cut = Cut(mix(topsoil, subsoil, below_roots) * (1.0 + 0.10 * broad + 0.20 * crumb.x),
                  crumb.yz + vec2(0.12 * value_noise(vec2(at.x * 13.0, at.y * 2.0)), 0.0));
    vec4 pebble = stone(at, 150.0, 0.30 * below_roots);
    vec4 cobble = stone(at + 0.37, 47.0, 0.10 + 0.35 * deep);
    if (cobble.x > 0.0) pebble = cobble;
    vec3 grey = mix(vec3(0.30, 0.245, 0.195), vec3(0.52, 0.46, 0.385), pebble.y);
    cut.albedo = mix(cut.albedo, grey * (1.0 + 0.08 * crumb.x), pebble.x);
    cut.slope = mix(cut.slope, 0.25 * cut.slope - pebble.zw, pebble.x);
    return cut;
}
