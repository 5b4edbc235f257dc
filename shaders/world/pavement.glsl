// Desert pavement up close: stones that the wind has left where it took the sand, most dark with varnish, some pale, and streaks of
// sand in the lee of larger ones. Needs common/noise.glsl and bed/ground.glsl before it. Lengths in metres, where there are metres.

// In the part `share` of the cells of so wide a lattice a stone, none across a cell's edge: slope along x and y, and how much lighter.
// Stones finer than `footprint` are left out.
vec3 stones(vec2 p, float spacing, float share, float footprint) {
    float visible = 1.0 - smoothstep(0.3, 0.9, footprint / spacing);
    vec2 place = p / spacing;
    ivec2 cell = ivec2(floor(place));
    float chance = hash(cell + ivec2(211, 17));
    float size = hash(cell + ivec2(5, 83));
    float radius = mix(0.12, 0.48, size * size);
    vec2 middle = vec2(0.5) + (0.5 - radius) * hash_vector(cell);
    vec2 from_middle = (fract(place) - middle) / radius;
    vec2 lean = hash_vector(cell + ivec2(71, 409));
    float reach = length(from_middle) * (1.0 + 0.25 * dot(normalize(from_middle + 1e-4), lean));
    float inside = (1.0 - smoothstep(0.75, 1.0, reach)) * step(chance, share);
    float pale = smoothstep(0.86, 0.9, hash(cell + ivec2(37, 3)));
    float tone = mix(-0.22 + 0.22 * lean.x, 0.45, pale);
    return visible * inside * vec3(-from_middle - 0.3 * lean, tone);
}

// A normal on pavement, and its colour, in the part `share` of a sample that is such ground.
void pave(inout vec3 normal, inout vec3 albedo, vec2 at, vec2 wind, float footprint, float share) {
    const mat2 turned = mat2(0.8, 0.6, -0.6, 0.8);
    float broad = value_noise(at * 0.04 + 5.3) + 0.5 * value_noise(at * 0.11 + 1.9);
    vec3 fine = stones(at, 0.05, 0.9, footprint);
    vec3 middle = stones(turned * at + 3.1, 0.14, 0.6, footprint);
    vec3 large = stones(at * turned + 7.7, 0.45, 0.10 + 0.12 * max(broad, 0.0), footprint);
    middle.xy = middle.xy * turned;
    large.xy = turned * large.xy;
    vec3 sum = 0.9 * fine + middle + large;
    vec2 along = vec2(dot(at, wind), dot(at, vec2(-wind.y, wind.x)));
    float wide = 1.0 - smoothstep(0.35, 1.0, footprint / 1.1);
    float streak = 0.6 * wide * value_noise(along / vec2(7.0, 1.1)) + 0.5 * value_noise(along / vec2(31.0, 4.3) + 2.7) + 0.3 * broad;
    float covered = smoothstep(0.05, 0.9, streak);
    vec3 ground = albedo * (1.0 + 0.10 * broad) * max(1.0 + (1.0 - 0.7 * covered) * sum.z, 0.3);
    ground = mix(ground, 0.5 * (sand_crest + sand_trough), 0.55 * covered);
    vec3 tilted = normalize(normal - vec3(0.5 * share * (1.0 - 0.7 * covered) * sum.xy, 0.0));
    normal = share > 0.0 ? tilted : normal;
    albedo = mix(albedo, ground, share);
}
