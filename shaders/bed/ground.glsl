// The ground's own colour, and the light it sends to the eye. Needs common/light.glsl,
// common/oren_nayar.glsl and bed/bed.glsl before it.
uniform sampler2D palette;
uniform float natural;  // 1: sand and rock by themselves, 0: the palette
uniform float rock;     // 0 sand … 1 mountains
uniform sampler2D noise_map;  // of bed/ground_noise.frag.glsl
uniform vec2 noise_origin;    // the drawn bed's corner there

// It is one tile's.
vec2 noise_position(vec2 position) { return plain < 0.5 ? position + noise_origin : vec2(2.0, 1.0) * position; }

uniform vec3 sand_crest;
uniform vec3 sand_trough;

vec3 sand(float broad, float fine, BedPoint point, float height) {
    float open = clamp(0.35 + 0.45 * height + 0.9 * (point.sky - 0.85), 0.0, 1.0);
    open = clamp(open + 0.10 * broad + 0.04 * fine, 0.0, 1.0);
    return mix(sand_trough, sand_crest, open) * (1.0 + 0.035 * broad + 0.02 * fine);
}

vec3 mountain(float broad, BedPoint point, float height) {
    float steep = smoothstep(0.10, 0.36, 1.0 - point.normal.z + 0.03 * broad);
    vec3 low_ground = mix(vec3(0.50, 0.315, 0.165), vec3(0.68, 0.48, 0.295), clamp(height + 0.12 * broad, 0.0, 1.0));
    vec3 cliff = mix(vec3(0.38, 0.195, 0.110), vec3(0.54, 0.36, 0.245), clamp(height + 0.2 * broad, 0.0, 1.0));
    return mix(low_ground, cliff, steep);
}

uniform float covered;  // 1: grass, rock, soil and snow by rule
uniform sampler2D cover_map;  // how green grass is, how much of it, of rock and of snow there is

uniform vec2 bare_board;  // palette places from which grains of a pile begin to hide its board, and hide it; 0: none is seen

float sand_on_board(float value) { return bare_board.y > 0.0 ? smoothstep(bare_board.x, bare_board.y, value) : 1.0; }

// Plaster, lighter than the sand.
vec3 board() {
    vec3 ground = mix(sand_trough, sand_crest, 0.5);
    return mix(vec3(luminance(ground)), ground, 0.14) * 1.35;
}

float grown = 0.0;  // 0 … 1: how far grass covers the place of the last with_cover()

// Edges between them are as ragged as the noise.
vec3 with_cover(vec3 own, vec2 position, vec3 noise) {
    vec4 cover = texture(cover_map, position);
    float grass = smoothstep(0.25, 0.75, cover.g + 0.30 * noise.r + 0.15 * noise.g);
    float stone = smoothstep(0.35, 0.65, cover.b + 0.20 * noise.g + 0.10 * noise.b);
    float snow = smoothstep(0.40, 0.60, cover.a + 0.25 * noise.g * step(0.004, cover.a) * step(cover.a, 0.996));
    vec3 meadow = mix(vec3(0.235, 0.205, 0.115), vec3(0.100, 0.124, 0.048), clamp(cover.r + 0.25 * noise.b, 0.0, 1.0)) * (1.0 + 0.12 * noise.g);
    vec3 soil = mix(own, vec3(0.250, 0.205, 0.155), 0.75);
    vec3 cliff = mix(0.92 * soil, vec3(0.262, 0.228, 0.188), rock);  // earth where the relief is that of a gully
    vec3 bare = mix(soil, cliff * (1.0 + 0.22 * noise.g), stone);
    grown = grass * (1.0 - stone);
    return mix(mix(bare, meadow, 0.92 * grown), vec3(0.80, 0.83, 0.88), snow);
}

// How much of rock is seen.
float bare_rock(vec2 position) {
    if (covered < 0.5) return 1.0;
    vec4 cover = texture(cover_map, position);
    return cover.b * (1.0 - cover.a);
}

vec3 ground_albedo(vec2 position, BedPoint point, float value) {
    vec3 noise = 2.0 * texture(noise_map, noise_position(position)).rgb - 1.0;
    vec3 own = mix(sand(1.5 * noise.r, noise.g, point, value), mountain(1.5 * noise.b, point, value), rock);
    if (covered > 0.5) own = with_cover(own, position, noise);
    if (bare_board.y > 0.0) own = mix(board(), own, sand_on_board(value));
    if (natural > 0.5) return marked(own, position);
    vec3 coloured = linear_from_display(texture(palette, vec2(value * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb);
    return marked(mix(coloured, own, texture(uncoloured_map, position).r), position);
}

vec3 ground_albedo(vec2 position, BedPoint point) { return ground_albedo(position, point, texture(value_map, position).r); }

bool eroded = false;  // on ground that water shapes, whose banks stand over against each other

// What reaches a place: the sun's light, the sky's, and that of ground around, whose colour is `albedo`.
vec3 light_onto(vec3 from_sun, vec3 albedo, BedPoint point) {
    // The sky is brighter on the sun's side.
    vec3 sky = sky_light * point.sky * (1.0 + 0.25 * dot(point.normal.xy, to_sun.xy));
    // One bounce: what the sky does not fill, sunlit sand around does.
    vec3 bounce = albedo * (sun_light * max(to_sun.z, 0.15) + 0.5 * sky_light) * (1.0 - point.sky) * 1.7;
    if (atmosphere > 0.5) {
        float x = dot(point.normal.xy, normalize(to_sun.xy + vec2(1e-6, 0.0)));
        // The lean is fitted over slopes of up to 45 degrees: steeper ones get what those do.
        float tilt = min(1.0, 0.70711 / max(length(point.normal.xy), 1e-6));
        float t = min(1.0 - point.normal.z, 0.29289);
        vec3 lean = tilt * x * (sky_lean_x + tilt * x * sky_lean_xx + t * sky_lean_tx) + t * sky_lean_t;
        sky = sky_light * point.sky * max(1.0 + lean, 0.1);
        // A slope sees level ground, half of it in the sun, where it does not see the sky.
        float ground_seen = clamp(1.0 - point.sky, 0.0, 1.0);
        float lit = 0.5 * to_sun.z;
        // Between hills a slope in shade sees the one that faces the sun.
        if (covered > 0.5 || eroded) lit = mix(lit, 0.8 * dot(vec2(0.5, 0.87), vec2(length(to_sun.xy), to_sun.z)), clamp(-2.0 * x, 0.0, 1.0));
        bounce = albedo * (sun_light * lit + sky_light) * ground_seen;
    }
    return from_sun + sky + bounce;
}

// Mean of what a surface gets of the sun whose slope varies by `spread` about the mean in the sun's direction, and by its
// grains.
float mean_facing(float n_dot_l, float spread) {
    const float grains = 0.06;
    return 0.5 * (n_dot_l + sqrt(n_dot_l * n_dot_l + 0.7 * (spread * spread + grains * grains)));
}

// What a rough surface throws to the eye of the sun's light that it gets.
float roughened(float direct, vec3 normal, vec3 to_eye, float least) {
    float n_dot_l = max(dot(normal, to_sun), least);
    return direct / n_dot_l * oren_nayar(n_dot_l, max(dot(normal, to_eye), 0.0), dot(to_sun, to_eye));
}

// From the sun's share that leaves it, `direct`. `around`: the colour of ground around. `gloss` is 1 for dry ground.
vec3 ground_light_of(vec3 albedo, vec3 around, float direct, BedPoint point, vec3 to_eye, float gloss) {
    float n_dot_l = max(dot(point.normal, to_sun), 0.0);
    vec3 halfway = normalize(to_sun + to_eye);
    float shine = max(dot(point.normal, halfway), 0.0);
    shine *= shine; shine *= shine; shine *= shine;
    return albedo * light_onto(sun_light * direct, around, point) + sun_light * (0.035 * gloss * shine * point.sun * n_dot_l);
}

vec3 ground_light_of(vec3 albedo, float direct, BedPoint point, vec3 to_eye, float gloss) { return ground_light_of(albedo, albedo, direct, point, to_eye, gloss); }

vec3 ground_light(vec3 albedo, BedPoint point, vec3 to_eye, float gloss) {
    float n_dot_l = max(dot(point.normal, to_sun), 0.0);
    float n_dot_v = max(dot(point.normal, to_eye), 0.0);
    float direct = point.sun * oren_nayar(n_dot_l, n_dot_v, dot(to_sun, to_eye));
    return ground_light_of(albedo, direct, point, to_eye, gloss);
}
