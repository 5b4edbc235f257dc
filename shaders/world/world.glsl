// Sand to the horizon, shaded where the triangles said that it is: once a pixel where all its samples see the same
// ground, else once a sample. Needs common/colour.glsl, common/light.glsl, common/noise.glsl, common/oren_nayar.glsl, bed/bed.glsl, bed/ground.glsl
// and world/world_position.glsl before it.
#include "world/tile_warp.glsl"
#include "streamers/streamers.glsl"
uniform vec2 first_of_tile;    // the sample of its lower left pixel
uniform float curvature;      // of the planet, 1 / (2 R)
uniform vec2 whole_eye;       // the eye's place, not reduced to one period
uniform float sand_grain;     // how much of it is seen
uniform float ripple_length;  // block lengths
uniform float ripple_slope;   // steepest
uniform vec2 wind;            // where it blows to, unit vector

uniform float sample_angle;    // between two samples
uniform float sample_share;    // of a sample's extent, over which its textures are averaged
uniform float single_surface_pixels;    // 1: colours pixels of one ground, 0: samples of the others

uniform sampler2D albedo_map;  // roots and bare sand, of bed/shade_albedo.frag.glsl
uniform sampler2D surface_map; // how far ground upwind leaves the wind to the bed; how far sand lies as it slid
uniform sampler2D relief_map;  // of world/relief.frag.glsl
out vec4 colour;

// Of a pixel's extent, over which textures are averaged; samples of its own would be averaged over half of it each.
const float crisp = 0.7;

// Grains are as large as the pixels see them, also where samples are looked at more finely.
const float pixel_footprint_scale = sample_share == 1.0 ? 1.0 : crisp / sample_share;

// The difference to the nearer of two neighbours: across an edge there is other ground.
vec3 nearer(vec3 one, vec3 other) { return dot(one, one) < dot(other, other) ? one : other; }

// Of the places of three samples in a row; one that sees the sky has none.
vec3 change(vec3 before, vec3 at, vec3 after) {
    bool none_before = before == vec3(0.0);
    bool none_after = after == vec3(0.0);
    return none_before && none_after ? vec3(0.0) : none_before ? after - at : none_after ? at - before : nearer(at - before, after - at);
}

// The same for far ground at grazing view, where neighbours may lie on other crests: from the sample's own visible point.
SurfacePoint far_surface_point() {
    SurfacePoint position;
    float spread = sample_angle;
    float slant;
    if (single_surface_pixels > 0.5) {
        position = pixel_surface_point(slant);
        slant *= crisp;
        spread *= crisp * float(factor);
    } else {
        vec4 visibility = visibility_at(own_sample());
        position.offset = visibility.xyz;
        slant = sample_share * visibility.w;
    }
    vec2 view = normalize(position.offset.xy + 1e-9);
    position.along = vec3(-view.y, view.x, 0.0) * (spread * length(position.offset));
    position.up = vec3(view * slant, 0.0);
    return position;
}

SurfacePoint near_surface_point() {
    if (single_surface_pixels > 0.5) {
        float slant;
        SurfacePoint pixel = pixel_surface_point(slant);
        pixel.along *= crisp;
        pixel.up *= crisp;
        return pixel;
    }
    ivec2 at = own_sample();
    SurfacePoint position;
    position.offset = visibility_at(at).xyz;
    vec3 west = is_beyond(at - ivec2(1, 0)) ? vec3(0.0) : visibility_at(at - ivec2(1, 0)).xyz;
    vec3 east = is_beyond(at + ivec2(1, 0)) ? vec3(0.0) : visibility_at(at + ivec2(1, 0)).xyz;
    vec3 south = is_beyond(at - ivec2(0, 1)) ? vec3(0.0) : visibility_at(at - ivec2(0, 1)).xyz;
    vec3 north = is_beyond(at + ivec2(0, 1)) ? vec3(0.0) : visibility_at(at + ivec2(0, 1)).xyz;
    position.along = sample_share * change(west, position.offset, east);
    position.up = sample_share * change(south, position.offset, north);
    return position;
}

WarpedGround warp_at(SurfacePoint at) { return warped_ground(at.offset.xy); }
vec2 bed_position(SurfacePoint at, WarpedGround copy) { return map_position(eye.xy + at.offset.xy) + copy.offset; }

// The bed's point as its copy stands.
BedPoint warped(BedPoint point, SurfacePoint at, WarpedGround copy) {
    if (varied < 0.5) return point;
    float z = eye.z + at.offset.z + curvature * dot(at.offset.xy, at.offset.xy);
    vec2 slope = warped_slope(copy, -point.normal.xy / max(point.normal.z, 0.1), z);
    point.normal = vec3(-slope, 1.0) * (length(point.normal) * inversesqrt(1.0 + dot(slope, slope)));
    return point;
}

// Texels to a block length, of a map of so many along its side.
float texels_of(int count) { return float(count) / (plain < 0.5 ? extent.x : 2.0 * extent.x); }

// Brightness of grains, as fine as is seen at any distance: two octaves of noise in turn, as strong between them as in
// one. On floors dark stones and some pale ones stand out.
float grain(SurfacePoint at, float bare) {
    vec2 footprint = pixel_footprint_scale * (abs(at.along.xy) + abs(at.up.xy));
    float octave = log2(max(1.8 * max(footprint.x, footprint.y), 1e-9));
    float whole = floor(octave);
    vec2 position = (whole_eye + at.offset.xy) * exp2(-whole);
    float share = octave - whole;
    float noise = mix(value_noise(position), value_noise(0.5 * position + 31.7), share) * inversesqrt(1.0 - 2.0 * share * (1.0 - share));
    float stones = 0.8 * smoothstep(0.3, 0.8, noise) - 1.2 * smoothstep(0.2, 0.7, -noise) + 0.15;
    return mix(stones, 0.8 * noise, bare);
}

// The level of a texture's means over what is seen, with so many texels to a block length.
float coarseness(SurfacePoint at, float texels) {
    return 0.5 * log2(max(max(dot(at.along.xy, at.along.xy), dot(at.up.xy, at.up.xy)) * (texels * texels), 1e-12));
}

// Slope of the sand's own unevenness between ripples and cells, east and north, and how much lighter it is: longer along
// the crests of ripples than across, and on floors less of what is wide. What is fine and seen
// aslant is looked at twice, in both halves of its longer side, so that it stays as sharp as along the shorter one.
vec3 relief(SurfacePoint at, float bare) {
    const mat2 turned = mat2(0.96, 0.28, -0.28, 0.96);
    const float wider = 1.0 / 22.6;  // about where the octaves of one texture end those of the other begin
    const float longer = 0.6;        // along the crests of ripples: one over how much
    float weaker = mix(0.45, 0.8, bare);
    float scale = 1.0 / (70.0 * ripple_length);
    mat2 by_wind = mat2(wind.x, -longer * wind.y, wind.y, longer * wind.x);
    vec2 position = by_wind * (whole_eye + at.offset.xy) * scale;
    vec2 position_along = by_wind * at.along.xy;
    vec2 position_up = by_wind * at.up.xy;
    float along = dot(position_along, position_along);
    float up = dot(position_up, position_up);
    vec2 aside = 0.25 * scale * (along > up ? position_along : position_up);
    float texels = scale * float(textureSize(relief_map, 0).x);
    float extent_seen = max(min(along, up), 0.25 * max(along, up));
    float level = 0.5 * log2(max(extent_seen * (texels * texels), 1e-12));
    vec3 fine = vec3(-0.5);
    vec3 broad = textureLod(relief_map, wider * (turned * position) + 0.37, level + log2(wider)).rgb - 0.5;
    for (int i = 0; i < 2; ++i) {
        vec2 half_seen = i == 0 ? position - aside : position + aside;
        fine += 0.5 * textureLod(relief_map, half_seen, level).rgb;
    }
    broad.xy = broad.xy * turned;
    vec3 sum = fine + weaker * broad;
    return vec3(sum.xy * by_wind, sum.z);
}

vec4 sand_colour(SurfacePoint at, vec2 position) { return textureLod(albedo_map, position, coarseness(at, texels_of(textureSize(albedo_map, 0).x))); }

// Slope and brightness of the sand's unevenness, and how much grains differ: stones on bare floors the most.
vec3 unevenness(float bare) { return vec3(vec2(0.25), 0.62) * sand_grain * (marks > 1.5 ? bare : 0.35 + 0.65 * bare); }
float grains_of(float bare) { return sand_grain * (marks > 1.5 ? 0.18 : 0.27 - 0.11 * bare); }

// How much of that there is where sand slid: it lies smooth, but its grains are as many.
vec2 uneven_share(float bare, float slid) { return vec2(1.0) - vec2(0.6, 0.2) * (bare * slid); }

vec3 albedo_of(vec4 sand, float brighter) { return sand.rgb * sand.rgb * max(1.0 + brighter, 0.1); }

// How far a place is rock that weathers: as marked, or mountains of a bed that ends in a plain.
float weathered(vec2 position) { return marks > 1.5 ? rock_share(position) : plain * rock * bare_rock(position); }

// Whether there is any.
bool has_rock() { return marks > 1.5 || plain * rock > 0.0; }

// How far ripples stand on bare sand of a steepness that the wind reaches.
float rippled(float bare, float open, float steep) { return bare * smoothstep(0.15, 0.6, open) * (1.0 - smoothstep(0.52, 0.64, steep)); }

// The way that ripples face on a slope: sand that rolls downslope turns their crests.
vec2 facing_of(vec2 slope) {
    vec2 turned = wind - 0.8 * slope;
    return turned / max(length(turned), 0.2);
}

// Of the cosine between normal and sun, for the next function: rock's normals vary more than it knows.
float least_facing(float rocky) { return mix(0.02, 0.25, rocky); }

// Lengths and places in metres, or, without metres, in units to which a cell is 0.4.
float metres(float block_lengths) { return block_lengths * (0.12 / ripple_length); }
vec3 in_metres(vec3 offset) { return vec3(whole_eye + offset.xy, offset.z + eye.z) * (0.12 / ripple_length); }

// How much of the sand's unevenness is seen as slopes, and the variance of the rest, of which `mean_facing` gives the mean
// light: where the sun stands little higher than those slopes, bumps that are few pixels wide shade one another.
// `n_dot_l`: of the bed without them. `steepness`: what relief() is multiplied by, whose own slope deviates by about 0.4.
vec2 kept_unevenness(SurfacePoint at, float n_dot_l, float steepness) {
    float footprint = metres(max(length(at.along), length(at.up)));
    float deviation = 0.4 * steepness;
    float unshaded = smoothstep(1.0, 4.0, n_dot_l / max(deviation, 1e-4));
    float kept = mix(1.0, unshaded, smoothstep(0.01, 0.05, footprint));
    return vec2(kept, deviation * deviation * (1.0 - kept * kept));
}

// How much of light at a place is left by the air before it, a mean of the colours.
float seen_through_air(SurfacePoint at) { return dot(air_left(length(at.offset)), vec3(1.0 / 3.0)); }

// What the eye gets of light that leaves the ground, which gets a share of the sun.
vec4 colour_at_eye(vec3 light, SurfacePoint at, vec3 to_eye, float sun) {
    vec3 through = air_left(length(at.offset));
    light = mix(haze_before(at.offset, sun), light, through) + glare(-to_eye);
    if (streamers > 0.5) {
        ivec2 pixel = single_surface_pixels > 0.5 ? ivec2(gl_FragCoord.xy) : ivec2(floor((vec2(own_sample()) - first_of_tile) / float(factor)));
        light = through_streamers(light, pixel);
    }
    return vec4(display_from_linear(tone_curve(light)), 1.0);
}
