// Sand to the horizon, shaded once a sample, where the triangles said that it is. Needs colour.glsl, light.glsl, noise.glsl, oren_nayar.glsl,
// bed.glsl and ground.glsl before it.
uniform vec2 whole_eye;       // the eye's place, not reduced to one period
uniform float sand_grain;     // how much of it is seen
uniform float ripple_length;  // block lengths

uniform float sample_angle;   // between two samples

uniform sampler2D offsets;     // of what samples see from the eye, and lengths, of world_seen.frag.glsl; nothing seen: 0
uniform sampler2D albedo_map;  // roots and bare sand, of shade_albedo.frag.glsl
out vec4 colour;

// A place on the ground, and how it changes to the next sample along both sides of the picture.
struct SeenPlace {
    vec3 offset;  // from the eye
    vec3 along;
    vec3 up;
};

// The difference to the nearer of two neighbours: across an edge there is other ground.
vec3 nearer(vec3 one, vec3 other) { return dot(one, one) < dot(other, other) ? one : other; }

// Of the places of three samples in a row; one that sees the sky has none.
vec3 change(vec3 before, vec3 at, vec3 after) {
    bool none_before = before == vec3(0.0);
    bool none_after = after == vec3(0.0);
    return none_before && none_after ? vec3(0.0) : none_before ? after - at : none_after ? at - before : nearer(at - before, after - at);
}

// The same of far ground, which is seen so aslant that its neighbours may be on other crests: from what the sample sees.
SeenPlace far_place() {
    vec4 seen = texelFetch(offsets, ivec2(gl_FragCoord.xy), 0);
    vec2 view = normalize(seen.xy + 1e-9);
    SeenPlace place;
    place.offset = seen.xyz;
    place.along = vec3(-view.y, view.x, 0.0) * (sample_angle * length(seen.xyz));
    place.up = vec3(view * seen.w, 0.0);
    return place;
}

vec3 offset_at(ivec2 sample_place) { return texelFetch(offsets, sample_place, 0).xyz; }

SeenPlace seen_place() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(offsets, 0) - 1;
    SeenPlace place;
    place.offset = offset_at(at);
    vec3 west = at.x == 0 ? vec3(0.0) : offset_at(at - ivec2(1, 0));
    vec3 east = at.x == last.x ? vec3(0.0) : offset_at(at + ivec2(1, 0));
    vec3 south = at.y == 0 ? vec3(0.0) : offset_at(at - ivec2(0, 1));
    vec3 north = at.y == last.y ? vec3(0.0) : offset_at(at + ivec2(0, 1));
    place.along = change(west, place.offset, east);
    place.up = change(south, place.offset, north);
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

vec4 sand_colour(SeenPlace at) { return textureGrad(albedo_map, bed_place(at), at.along.xy / extent, at.up.xy / extent); }

vec3 albedo_of(vec4 sand, float brighter) { return sand.rgb * sand.rgb * (1.0 + brighter); }

// Lengths and places in metres, or, without metres, in units to which a cell is 0.4.
float metres(float block_lengths) { return block_lengths * (0.12 / ripple_length); }
vec3 in_metres(vec3 offset) { return vec3(whole_eye + offset.xy, offset.z + eye.z) * (0.12 / ripple_length); }

// What the eye gets of light that leaves the ground.
vec4 seen(vec3 light, SeenPlace at, vec3 to_eye) {
    float through = exp(-extinction * length(at.offset));
    vec2 level = at.offset.xy + 1e-6 * to_sun.xy;
    vec3 haze = haze_towards(vec3(normalize(level), 0.0));
    light = mix(haze, light, through) + glare(-to_eye);
    return vec4(display_from_linear(tone_curve(light)), 1.0);
}
