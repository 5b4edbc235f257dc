// What is known of the bed at a place (0 … 1): the lighting texture of render/lighting.h.
uniform sampler2D lighting_map;
uniform sampler2D value_map;  // palette places
uniform float paved;          // 1: level rock is desert pavement
uniform float marks;          // 1: some cells stand out, 2: plants and rock do
uniform sampler2D mark_map;   // 0 … 1: how much a cell stands out; of plants and rock 128/255 is bare sand
uniform sampler2D uncoloured_map;  // 1: the cell has no palette place
uniform vec2 extent;          // of the block
uniform float sun_span;       // of the sun's share in lighting_map, over the edges of shadows
uniform float sun_lowest;

uniform vec3 eye;        // perspective
uniform vec3 eye_axis;   // towards the eye, for views without perspective
uniform float parallel;  // 1: without perspective

// Endless ground of a bed that ends in a plain; see GroundTiles. `extent` is then that of its tile.
uniform float plain;

// In the maps, of a place from the bed's middle; and of a way from one place to another.
vec2 map_position(vec2 at) {
    vec2 tiles = at / extent + 0.5;
    if (plain < 0.5) return tiles;
    vec2 whole = floor(tiles);
    bool own = whole.x == 0.0 && whole.y == 0.0;
    return vec2(0.5 * (tiles.x - whole.x + (own ? 0.0 : 1.0)), tiles.y - whole.y);
}
vec2 map_offset(vec2 way) { return plain < 0.5 ? way / extent : way / (vec2(2.0, 1.0) * extent); }

struct BedPoint {
    vec3 normal;
    float sun;
    float sky;
};

BedPoint bed_point(vec4 texel) {
    vec2 slope = texel.xy * (65535.0 / 32767.0) - 1.0;
    BedPoint point;
    point.normal = vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
    point.sun = clamp(sun_lowest + sun_span * texel.z, 0.0, 1.0);
    point.sky = texel.w;
    return point;
}

BedPoint bed_point(vec2 position) { return bed_point(texture(lighting_map, position)); }

// The mean over what a sample sees of ground that lies aslant to the view: of four places along it. `along` and
// `across` are how the place changes to the next samples.
BedPoint slanting_bed_point(vec2 position, vec2 along, vec2 across) {
    if (dot(along, along) < dot(across, across)) {
        vec2 other = along;
        along = across;
        across = other;
    }
    vec2 size = vec2(textureSize(lighting_map, 0));
    float texels = max(0.25 * length(along * size), length(across * size));
    float level = log2(max(texels, 1.0));
    BedPoint mean = BedPoint(vec3(0.0), 0.0, 0.0);
    for (int i = 0; i < 4; ++i) {
        BedPoint point = bed_point(textureLod(lighting_map, position + (0.25 * float(i) - 0.375) * along, level));
        mean.normal += 0.25 * point.normal;
        mean.sun += 0.25 * point.sun;
        mean.sky += 0.25 * point.sky;
    }
    return mean;
}

vec3 direction_to_eye(vec3 point) { return mix(normalize(eye - point), eye_axis, parallel); }

// Of plants, and of rock on which no sand lies.
vec2 plants_and_rock(vec2 position) {
    float ground = (255.0 * texture(mark_map, position).r - 128.0) / 127.0;
    return vec2(smoothstep(0.0, 0.8, ground), smoothstep(0.2, 0.8, -ground));
}

// Of rock alone; 0 where it is not marked.
float rock_share(vec2 position) { return marks < 1.5 ? 0.0 : plants_and_rock(position).y; }

// How far a place is bare sand, in which ripples stand.
float bare_sand(vec2 position) {
    if (marks < 1.5) return 1.0;
    vec2 others = plants_and_rock(position);
    return (1.0 - others.x) * (1.0 - others.y);
}

vec3 marked(vec3 albedo, vec2 position) {
    if (marks < 0.5) return albedo;
    if (marks < 1.5) return mix(albedo, vec3(0.030, 0.120, 0.330), texture(mark_map, position).r);
    // Dry grass between whose tufts sand shows, and weathered rock.
    vec2 others = plants_and_rock(position);
    albedo = mix(albedo, vec3(0.140, 0.132, 0.066), 0.9 * others.x);
    return mix(albedo, mix(vec3(0.275, 0.195, 0.140), vec3(0.195, 0.160, 0.133), paved), others.y);
}
