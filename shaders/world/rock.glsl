// Weathered rock up close: beds of unequal hardness with ledges between them, joints that part them into blocks, and roughness at
// every size that is seen. Needs common/noise.glsl before it. Lengths in metres, where there are metres.

uniform float bedded;  // 1: walls show beds and joints, 0: no more than roughness

// Of a wall's or a floor's plane: the slope of its roughness along both axes, and its height against the usual. Octaves
// finer than `footprint` are left out.
vec3 rock_roughness(vec2 p, float footprint) {
    vec3 sum = vec3(0.0);
    for (int octave = 0; octave < 4; ++octave) {
        float k = 0.45 * exp2(1.7 * float(octave));
        float visible = 1.0 - smoothstep(0.2, 0.7, footprint * k);
        vec3 noise = sloped_gradient_noise(p * k + 17.4 * float(octave));
        sum += visible * vec3(0.17 * noise.yz, 0.30 * noise.x);
    }
    return sum;
}

// What a wall of rock is at a place.
struct Wall {
    float rise;     // how fast it comes out of the wall upward: above 0 under an overhang
    float lighter;  // −1 … 1
    float crack;    // 0 … 1
    vec2 facet;     // how a block leans, along x and y
};

// Beds about so thick, and blocks in them: hard beds stand out, and joints, of which some are open, stand across the wall.
void add_beds(inout Wall wall, vec3 at, float height, vec2 across, float thickness, float footprint) {
    float visible = 1.0 - smoothstep(0.35, 0.9, footprint / thickness);
    float position = height / thickness;
    int bed = int(floor(position));
    float hard = hash(ivec2(bed, 71));
    float harder = hash(ivec2(bed + 1, 71)) - hard;  // the next one
    float width = clamp(1.5 * footprint / thickness, 0.3, 1.0);
    float t = clamp((fract(position) - 1.0 + width) / width, 0.0, 1.0);
    wall.rise += visible * 1.5 * harder * t * (1.0 - t) / width;
    wall.lighter += visible * 0.5 * (hard + harder * t * t * (3.0 - 2.0 * t) - 0.5);

    float size = thickness * (1.2 + 1.6 * hash(ivec2(bed, 29)));
    vec2 joints = at.xy / size + 40.0 * vec2(hash(ivec2(bed, 5)), hash(ivec2(bed, 11)));
    vec3 bend = sloped_noise(joints + vec2(0.0, 0.5 * position));
    joints += vec2(0.25 * bend.x, 0.1 * (bend.y + bend.z));
    vec2 joint = floor(joints + 0.5);
    vec2 opened = smoothstep(vec2(0.4), vec2(0.9), vec2(hash(ivec2(joint.x, 3 * bed)), hash(ivec2(joint.y, 3 * bed + 1))));
    float wide = 0.03 * sqrt(thickness);
    float open = max(wide, 0.5 * footprint) / size;
    vec2 lines = across * opened * (1.0 - smoothstep(vec2(0.5 * open), vec2(2.5 * open), abs(joints - joint)));
    wall.crack = max(wall.crack, visible * min(1.5 * wide / (open * size), 1.0) * max(lines.x, lines.y));
    ivec2 block = ivec2(floor(joints)) + ivec2(37 * bed, 101 * bed);
    vec2 lean = vec2(hash(block), hash(block + ivec2(0, 977))) - 0.5;
    wall.lighter += visible * 0.1 * lean.x;
    wall.facet += visible * 0.25 * lean;
}

// A normal on rock, and how its colour changes, in the part `share` of a sample that is rock.
void weather(inout vec3 normal, inout vec3 albedo, vec3 at, float footprint, float share) {
    float slope = length(normal.xy) / max(normal.z, 0.05);
    float steep = smoothstep(0.5, 1.0, slope);
    float benched = smoothstep(0.15, 0.7, slope);
    vec2 out_of_wall = normalize(normal.xy + vec2(1e-5, 0.0));
    vec3 side = vec3(-out_of_wall.y, out_of_wall.x, 0.0);
    vec3 on_floor = rock_roughness(2.6 * at.xy, 2.6 * footprint);
    // Walls take it from the two upright planes through the axes: along a wall that turns, a place far from the origin
    // would slip over it.
    float faces_x = smoothstep(0.3, 0.7, out_of_wall.x * out_of_wall.x);
    vec3 from_x = rock_roughness(vec2(at.y, 1.6 * at.z), footprint) * vec3(sign(side.y), 1.0, 1.0);
    vec3 from_y = rock_roughness(vec2(at.x, 1.6 * at.z) + 31.0, footprint) * vec3(sign(side.x), 1.0, 1.0);
    vec3 on_wall = mix(from_y, from_x, faces_x);

    float height = at.z + 0.9 * value_noise(at.xy * 0.05) + 0.2 * value_noise(at.xy * 0.4 + 9.0) + 0.8 * value_noise(vec2(at.z * 0.3, 3.5));
    vec2 across = smoothstep(0.9, 1.8, slope) * smoothstep(vec2(0.4), vec2(0.8), abs(side.xy));
    Wall wall = Wall(0.0, 0.0, 0.0, vec2(0.0));
    if (bedded > 0.5) {
        add_beds(wall, at, height, across, 6.1, footprint);
        add_beds(wall, at, height, across, 1.7, footprint);
        add_beds(wall, at, height, across, 0.47, footprint);
    }

    // A floor is swept and worn: stones, not ledges.
    vec3 tilt = mix(0.14 * vec3(on_floor.xy, 0.0), 0.6 * on_wall.x * side + vec3(0.5 * wall.facet, 0.6 * on_wall.y), steep);
    tilt.z += 0.75 * benched * wall.rise;
    float relief = mix(0.15 * on_floor.z, on_wall.z, steep);
    float lighter = mix(0.3, 1.0, benched) * wall.lighter;
    tilt *= 1.5 * share;
    tilt.z = min(tilt.z, normal.z - 0.15);  // what hangs over is a shadow; see below
    normal = normalize(normal - tilt);
    vec3 tinted = albedo * (1.0 + 0.8 * lighter + 0.35 * relief) * mix(vec3(1.0), vec3(1.10, 0.98, 0.88), clamp(0.5 + lighter, 0.0, 1.0));
    // Sand lies on ledges; little light comes under overhangs and into joints.
    tinted *= 1.0 - clamp(0.4 * wall.crack + 0.35 * benched * wall.rise, -0.15, 0.7);
    albedo = mix(albedo, max(tinted, 0.2 * albedo), share);
}

// How far grains and unevenness that lie on level ground are seen: on walls of rock they would be drawn out.
float level_share(float steep, float share) { return 1.0 - share * smoothstep(0.5, 1.0, steep); }
