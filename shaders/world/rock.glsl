// Weathered rock up close: beds of unequal hardness, ledges between them, and roughness at every size that is seen. Needs
// common/noise.glsl before it. Lengths in metres, where there are metres.

// Of a wall's or a floor's plane: the slope of its roughness along both axes, and its height against the usual. Octaves
// finer than `footprint` are left out.
vec3 rock_roughness(vec2 p, float footprint) {
    vec3 sum = vec3(0.0);
    for (int octave = 0; octave < 4; ++octave) {
        float k = 0.45 * exp2(1.7 * float(octave));
        float seen = 1.0 - smoothstep(0.15, 0.5, footprint * k);
        vec3 noise = sloped_noise(p * k + 17.0 * float(octave));
        sum += seen * vec3(0.17 * noise.yz, 0.30 * noise.x);
    }
    return sum;
}

// How much lighter a bed at a height is: −1 … 1.
float rock_bed(vec3 at, float footprint) {
    float height = at.z + 0.9 * value_noise(at.xy * 0.05) + 0.15 * value_noise(at.xy * 0.5 + 9.0);
    float thick = value_noise(vec2(height * 0.9, 3.5));
    float thin = value_noise(vec2(height * 3.7, 8.5)) * (1.0 - smoothstep(0.1, 0.4, footprint * 3.7));
    return 0.65 * thick + 0.35 * thin;
}

// A normal on rock, and how its colour changes, in the part `share` of a sample that is rock.
void weather(inout vec3 normal, inout vec3 albedo, vec3 at, float footprint, float share) {
    float wall = smoothstep(0.5, 1.1, length(normal.xy) / max(normal.z, 0.05));
    vec2 out_of_wall = normalize(normal.xy + vec2(1e-5, 0.0));
    vec3 side = vec3(-out_of_wall.y, out_of_wall.x, 0.0);
    vec3 on_floor = rock_roughness(2.6 * at.xy, 2.6 * footprint);
    // Walls take it from the two upright planes through the axes: along a wall that turns, a place far from the origin
    // would slip over it.
    float faces_x = smoothstep(0.3, 0.7, out_of_wall.x * out_of_wall.x);
    vec3 from_x = rock_roughness(vec2(at.y, 1.6 * at.z), footprint) * vec3(sign(side.y), 1.0, 1.0);
    vec3 from_y = rock_roughness(vec2(at.x, 1.6 * at.z) + 31.0, footprint) * vec3(sign(side.x), 1.0, 1.0);
    vec3 on_wall = mix(from_y, from_x, faces_x);
    // A floor is swept and worn: stones, not ledges.
    vec3 tilt = mix(0.14 * vec3(on_floor.xy, 0.0), on_wall.x * side + vec3(0.0, 0.0, on_wall.y), wall);
    float relief = mix(0.15 * on_floor.z, on_wall.z, wall);
    float bed = rock_bed(at, footprint) * mix(0.4, 1.0, wall);
    // Hard beds stand out, so that the foot of each is steeper.
    float higher = rock_bed(at + vec3(0.0, 0.0, 0.12), footprint);
    tilt.z += wall * 0.9 * (higher - bed);
    normal = normalize(normal - share * 1.5 * tilt);
    vec3 tinted = albedo * (1.0 + 0.30 * bed + 0.35 * relief) * mix(vec3(1.0), vec3(1.10, 0.98, 0.88), 0.5 + 0.5 * bed);
    albedo = mix(albedo, max(tinted, 0.3 * albedo), share);
}
