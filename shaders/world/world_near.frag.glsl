#version 330 core
// Sand so near that its wind ripples are seen, and the tongues of its avalanches.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "sky/cloud_shapes.glsl"
#include "common/noise.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "bed/drape.glsl"
#include "world/rock.glsl"
#include "world/pavement.glsl"
#include "world/world_position.glsl"
#include "world/world.glsl"
#include "world/wear.glsl"
#include "world/slip_faces.glsl"

uniform sampler2D wander_map;  // of world/ripple_wander.frag.glsl
uniform float wander_scale;    // of its side, a ripple's length
uniform float exaggeration;  // of heights
uniform float least_slip_slope;     // of ground that is true to nature: on none that falls less sand slid
uniform float min_avalanche_slope;  // by its slope in the bed's maps: on none that is less steep
uniform float ripple_phase;  // of the eye's place, in turns

// For pixels classified by PixelClasses.
uniform float plain_sand;  // 1: of plain ones alone
uniform float slid_sand;   // 0: of those alone on which no sand slid

const float tau = 6.2831853;

// Turns of a train of ripples from one place to another. Sand that rolls downslope turns crests: they run on around a
// dune as if each began that much later.
float turns(vec3 way) { return (dot(way.xy, wind) - 0.8 * way.z) / ripple_length; }

// How ripples wander: what is added to their phase, how high they stand, and a second train of waves, whose strength and
// phase wander. It cancels the first in places: there crests end or fork.
struct Wander {
    float turns;
    vec2 second;
    float height;
    float patches;  // 0 … 1, wide ones
};

Wander wander_at(vec2 position) {
    vec4 texel = texture(wander_map, position);
    Wander wander;
    wander.turns = 10.0 * texel.x - 5.0;
    wander.second = 4.0 * texel.yz - 2.0;
    float strength = length(wander.second);
    wander.second /= max(strength, 1e-3);
    wander.patches = texel.w;
    wander.height = 1.15 * texel.w * min(2.5 * strength, 1.0);
    return wander;
}

// Cosine and sine of the ripples' phase.
vec2 wave_of(Wander wander, float phase) {
    float turn = tau * fract(phase);
    float c = cos(turn);
    float s = sin(turn);
    return vec2(c * wander.second.x - s * wander.second.y, s * wander.second.x + c * wander.second.y);
}

// Slope of a ripple, of its phase's cosine: crests are sharper than troughs.
float profile(float c) { return c * (0.7 + 0.4 * c * c) - 0.3 * (2.0 * c * c - 1.0); }

// Grains that mirror the sun to the eye, seldom ones: each in a cell of its own on the ground, a few pixels wide or more.
float glints(SurfacePoint at, vec3 to_eye) {
    vec2 reach = pixel_footprint_scale * (abs(at.along.xy) + abs(at.up.xy));
    float size = log2(max(2.5 * metres(max(reach.x, reach.y)), 0.004));
    vec3 halfway = normalize(to_sun + to_eye);
    vec2 wanted = halfway.xy / max(halfway.z, 0.2);
    vec2 ground = in_metres(at.offset).xy;
    float sum = 0.0;
    for (int i = 0; i < 2; ++i) {
        float octave = floor(size) + float(i);
        vec2 position = ground * exp2(-octave);
        ivec2 cell = ivec2(floor(position));
        vec2 from_middle = position - floor(position) - 0.5;
        vec2 facet = vec2(hash(cell + ivec2(911, 37)), hash(cell + ivec2(13, 709)));
        float aligned = 1.0 - smoothstep(0.02, 0.08, distance(1.6 * facet - 0.8, wanted));
        float spot = 1.0 - smoothstep(0.10, 0.40, length(from_middle - 0.4 * (fract(7.0 * facet) - 0.5)));
        sum += aligned * spot * max(1.0 - abs(octave - size), 0.0);
    }
    return sum * (1.0 - smoothstep(-6.0, -4.0, size));
}

// What is finer than relief() has it: slope and how much lighter.
vec3 fine_relief(SurfacePoint at) {
    const mat2 turned = mat2(0.6, 0.8, -0.8, 0.6);
    float scale = 1.0 / (9.0 * ripple_length);
    float along = dot(at.along.xy, at.along.xy);
    float up = dot(at.up.xy, at.up.xy);
    float texels = scale * float(textureSize(relief_map, 0).x);
    float level = 0.5 * log2(max(max(min(along, up), 0.2 * max(along, up)) * (texels * texels), 1e-12));
    vec3 texel = textureLod(relief_map, turned * (whole_eye + at.offset.xy) * scale, level).rgb - 0.5;
    return vec3(texel.xy * turned, texel.z);
}

// The bed's slope at a place, without ripples.
struct Slope {
    BedPoint point;
    vec2 rise;
    float steep;
    vec2 across;
};

Slope slope_at(vec2 position, float level, SurfacePoint at, WarpedGround copy) {
    Slope slope;
    slope.point = bed_point(textureLod(lighting_map, position, level));
    if (plain_sand < 0.5) slope.point = warped(slope.point, at, copy);
    slope.rise = -slope.point.normal.xy / max(slope.point.normal.z, 0.1);
    slope.steep = length(slope.rise);
    slope.across = vec2(-slope.rise.y, slope.rise.x) / max(slope.steep, 0.1);
    return slope;
}

// What ripples need to know of a pixel.
struct Sand {
    float height;  // of ripples
    float phase;
    float resolved;
    float bare;
    float open;
    vec2 uneven;  // slope besides theirs
    float variance;  // of what is not in that slope
};

// What a part of a pixel gets of the light.
struct Lit {
    BedPoint point;
    float direct;
    float trough;
    float standing;
};

Lit lit_part(Slope slope, vec3 to_part, Sand sand, Wander wander) {
    Lit lit;
    lit.point = slope.point;
    lit.standing = sand.height * rippled(sand.bare, sand.open, slope.steep);
    vec2 wave = wave_of(wander, sand.phase + turns(to_part));
    vec2 facing = facing_of(slope.rise);
    vec2 tilt = facing * (ripple_slope * lit.standing * sand.resolved * profile(wave.x)) + sand.uneven;
    lit.point.normal = normalize(vec3(-slope.rise - tilt, 1.0));
    float spread = 0.7 * ripple_slope * lit.standing * (1.0 - sand.resolved) * dot(facing, to_sun.xy);
    lit.direct = lit.point.sun * mean_facing(dot(lit.point.normal, to_sun), sqrt(spread * spread + sand.variance));
    lit.trough = wave.y;
    return lit;
}

Lit mean_of(Lit one, Lit other) {
    Lit mean;
    mean.point = BedPoint(0.5 * (one.point.normal + other.point.normal), 0.5 * (one.point.sun + other.point.sun), 0.5 * (one.point.sky + other.point.sky));
    mean.direct = 0.5 * (one.direct + other.direct);
    mean.trough = 0.5 * (one.trough + other.trough);
    mean.standing = other.standing;
    return mean;
}

vec4 near_colour(SurfacePoint at) {
    vec3 offset = at.offset;
    WarpedGround copy = unwarped;
    if (plain_sand < 0.5) copy = warp_at(at);
    vec2 position = bed_position(at, copy);
    vec2 position_along = map_offset(at.along.xy);
    vec2 position_up = map_offset(at.up.xy);
    vec3 to_eye = -normalize(offset);
    vec4 sand = sand_colour(at, position);
    Laid laid = slanting_drape(position, position_along, position_up);
    if (draped > 0.5) sand.a *= 1.0 - laid.share;
    vec2 surface = textureLod(surface_map, position, coarseness(at, texels_of(textureSize(surface_map, 0).x))).rg;
    float open = surface.r;
    vec2 share = uneven_share(sand.a, surface.g);
    vec3 uneven = share.x * unevenness(sand.a) * (relief(at, sand.a) + 0.5 * fine_relief(at));
    if (draped > 0.5) uneven *= 1.0 - laid.share;

    vec2 lee = vec2(-wind.y, wind.x);  // along the crests
    vec2 whole = (whole_eye + offset.xy) / ripple_length;
    Wander wander = wander_at(wander_scale * vec2(dot(whole, wind), 0.75 * dot(whole, lee)));
    float phase = turns(offset) + ripple_phase + wander.turns;
    float footprint = abs(turns(at.along)) + abs(turns(at.up));
    if (single_surface_pixels > 0.5) footprint *= 0.5 / crisp;
    float resolved = 1.0 - smoothstep(0.05, 0.3, footprint);

    // The sun's share, a mean over both halves of the pixel: no loop, of whose body llvmpipe does all each time.
    vec2 texels = vec2(textureSize(lighting_map, 0));
    float level = log2(max(max(length(position_along * texels), length(position_up * texels)) * (single_surface_pixels > 0.5 ? 0.5 / crisp : 1.0), 1.0));
    if (plain_sand > 0.5) level = 0.0;
    vec3 to_half = single_surface_pixels > 0.5 ? (0.25 / crisp) * (at.up - at.along) : vec3(0.0);
    vec2 aside = plain_sand > 0.5 ? vec2(0.0) : map_offset(to_half.xy);
    Slope slope = slope_at(position + aside, level, at, copy);
    // Wind that reaches a slope smooths it, but not at the angle of repose.
    float smoothed = smoothstep(0.0, 0.3, open) * (1.0 - smoothstep(0.54, 0.64, slope.steep));
    float true_size = 1.0 / exaggeration;
    float slid = surface.g * smoothstep(min_avalanche_slope, 0.56, slope.steep * true_size) * smoothstep(least_slip_slope, min_avalanche_slope, fall_at(at) * true_size) * sand.a * (1.0 - 0.85 * smoothed) * (1.0 - plain * rock);
    vec3 tongue = vec3(0.0);
    if (slid_sand > 0.5) tongue = slid * tongues(at, slope.across);
    float steepness = share.x * unevenness(sand.a).x * (draped > 0.5 ? 1.0 - laid.share : 1.0);
    vec2 kept = kept_unevenness(at, dot(vec3(-slope.rise, 1.0), to_sun) * inversesqrt(1.0 + slope.steep * slope.steep), steepness);
    Sand here = Sand(wander.height, phase, resolved, sand.a, open, tongue.xy + kept.x * uneven.xy, kept.y);
    Lit lit = lit_part(slope, to_half, here, wander);
    if (single_surface_pixels > 0.5) {
        Slope other = slope;
        if (plain_sand < 0.5) other = slope_at(position - aside, level, at, copy);
        lit = mean_of(lit, lit_part(other, -to_half, here, wander));
    }
    BedPoint mean = lit.point;
    float direct = lit.direct;
    // Crests are of coarser, paler grains.
    float crest = ripple_slope * lit.standing * resolved * lit.trough;
    float rocky = has_rock() ? weathered(position) : 0.0;
    if (draped > 0.5) rocky *= 1.0 - laid.share;
    if (has_rock()) share.y *= level_share(slope.steep, rocky);
    vec3 albedo = albedo_of(sand, share.y * grains_of(sand.a) * grain(at, sand.a) + 0.1 * uneven.z + 0.15 * tongue.z + 0.2 * crest);
    if (has_rock()) {
        wear(mean.normal, albedo, at, rocky, slope.steep);
        direct = mix(direct, mean.sun * mean_facing(dot(mean.normal, to_sun), 0.25), rocky);
    }
    albedo = with_drape(albedo, laid);
    if (clouds > 0.5) {
        float shade = cloud_shade(offset);
        direct *= shade;
        mean.sun *= shade;
    }
    direct = roughened(direct, mean.normal, to_eye, least_facing(rocky));
    // Troughs see less of the sky.
    mean.sky *= 1.0 + 0.4 * ripple_slope * lit.standing * resolved * (lit.trough - 1.0);
    vec3 light = ground_light_of(albedo, direct, mean, to_eye, 1.0);
    light += sun_light * (0.4 * sand_grain * sand.a * mean.sun * glints(at, to_eye));
    vec4 lit_colour = colour_at_eye(light, at, to_eye, mean.sun);
    return vec4(as_it_is(lit_colour.rgb, laid, seen_through_air(at)), lit_colour.a);
}

void main() { colour = is_other_ground(near_ground) ? vec4(0.0) : near_colour(near_surface_point()); }
