// Sand to the horizon, shaded once a sample, where the triangles said that it is. Needs colour.glsl, light.glsl, noise.glsl, oren_nayar.glsl,
// bed.glsl and ground.glsl before it.
uniform vec2 whole_eye;       // the eye's place, not reduced to one period
uniform float sand_grain;     // how much of it is seen
uniform float ripple_length;  // block lengths

uniform sampler2D offsets;     // of what samples see from the eye, of world_seen.frag.glsl; nothing seen: 0
uniform sampler2D albedo_map;  // roots, of shade_albedo.frag.glsl
out vec4 colour;

// A place on the ground, and how it changes to the next sample along both sides of the picture.
struct SeenPlace {
    vec3 offset;  // from the eye
    vec3 along;
    vec3 up;
};

// The difference to the nearer of two neighbours: across an edge there is other ground.
vec3 nearer(vec3 one, vec3 other) { return dot(one, one) < dot(other, other) ? one : other; }

SeenPlace seen_place() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(offsets, 0) - 1;
    SeenPlace place;
    place.offset = texelFetch(offsets, at, 0).xyz;
    vec3 west = place.offset - texelFetch(offsets, ivec2(max(at.x - 1, 0), at.y), 0).xyz;
    vec3 east = texelFetch(offsets, ivec2(min(at.x + 1, last.x), at.y), 0).xyz - place.offset;
    vec3 south = place.offset - texelFetch(offsets, ivec2(at.x, max(at.y - 1, 0)), 0).xyz;
    vec3 north = texelFetch(offsets, ivec2(at.x, min(at.y + 1, last.y)), 0).xyz - place.offset;
    place.along = at.x == 0 ? east : at.x == last.x ? west : nearer(west, east);
    place.up = at.y == 0 ? north : at.y == last.y ? south : nearer(south, north);
    return place;
}

vec2 bed_place(SeenPlace at) { return (eye.xy + at.offset.xy) / extent + 0.5; }

// Unevenness of the sand, as fine as is seen at any distance: two octaves of noise in turn.
float grain(SeenPlace at) {
    vec2 footprint = abs(at.along.xy) + abs(at.up.xy);
    float octave = log2(max(3.0 * max(footprint.x, footprint.y), 1e-9));
    float whole = floor(octave);
    vec2 place = (whole_eye + at.offset.xy) * exp2(-whole);
    return mix(value_noise(place), value_noise(0.5 * place + 31.7), octave - whole);
}

vec3 sand_albedo(SeenPlace at, float brighter) {
    vec3 root = textureGrad(albedo_map, bed_place(at), at.along.xy / extent, at.up.xy / extent).rgb;
    return root * root * (1.0 + brighter);
}

// What the eye gets of light that leaves the ground.
vec4 seen(vec3 light, SeenPlace at, vec3 to_eye) {
    float through = exp(-extinction * length(at.offset));
    vec2 level = at.offset.xy + 1e-6 * to_sun.xy;
    vec3 haze = haze_towards(vec3(normalize(level), 0.0));
    light = mix(haze, light, through) + glare(-to_eye);
    return vec4(display_from_linear(tone_curve(light)), 1.0);
}
