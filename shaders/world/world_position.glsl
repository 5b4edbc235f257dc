// Where samples, and pixels of them, see the ground.
uniform vec2 first_sample;  // of the lower left pixel
uniform int factor;         // samples along each side of a pixel
uniform float samples_in_buffer;  // 1: what samples see is in seen_numbers, 0: in offsets
uniform sampler2D offsets;  // of what samples see from the eye, and lengths, of world/world_visibility.frag.glsl; nothing seen: 0
uniform float packed_samples;  // 1: colours samples of listed pixels, which lie side by side
uniform sampler2D listed;   // the first sample of each

// A place on the ground, and how it changes to the next sample or pixel along both sides of the picture.
struct SeenPlace {
    vec3 offset;  // from the eye
    vec3 along;
    vec3 up;
};

// The ground's slope there, as it is drawn.
float fall_at(SeenPlace place) {
    vec3 up = cross(place.along, place.up);
    return length(up.xy) / max(abs(up.z), 1e-20);
}

// See GroundSamples::see().
uniform usamplerBuffer seen_numbers;  // by fours
uniform vec2 numbers_begin;  // the sample that has the first of them
uniform float fours_a_row;
uniform float fours;  // of nearnesses, after which those of lengths begin
uniform vec2 target_begin;  // the picture's sample that is the target's first
uniform vec3 first_ray;  // over the nearness of what it meets
uniform vec3 ray_rightward;
uniform vec3 ray_upward;

// Where a sample's four numbers are: of two samples in a row, and of the two over them.
int four_of(ivec2 place) { return (place.y >> 1) * int(fours_a_row) + (place.x >> 1); }

uint number_at(ivec2 sample_place, int first_four) {
    ivec2 place = sample_place - ivec2(numbers_begin);
    uvec4 four = texelFetch(seen_numbers, first_four + four_of(place));
    uvec2 row = (place.y & 1) == 0 ? four.xy : four.zw;
    return (place.x & 1) == 0 ? row.x : row.y;
}

float nearness_of(uint number) { return uintBitsToFloat(number & ~7u); }
float nearness_at(ivec2 sample_place) { return nearness_of(number_at(sample_place, 0)); }

// Of what a sample sees, from the eye.
vec3 offset_of(ivec2 sample_place, float nearness) {
    vec2 in_picture = vec2(sample_place) + target_begin;
    vec3 ray = first_ray + in_picture.x * ray_rightward + in_picture.y * ray_upward;
    return ray * (nearness > 0.0 ? 1.0 / nearness : 0.0);
}

vec4 seen_at(ivec2 sample_place) {
    if (samples_in_buffer > 0.5)
        return vec4(offset_of(sample_place, nearness_at(sample_place)), uintBitsToFloat(number_at(sample_place, int(fours))));
    vec4 texel = texelFetch(offsets, sample_place, 0);
    return vec4(texel.xyz, abs(texel.w));
}

// Whether nothing is known of a sample; of those in seen_numbers all are that stand beside the tile's.
bool is_beyond(ivec2 sample_place) {
    if (samples_in_buffer > 0.5) return false;
    return any(lessThan(sample_place, ivec2(0))) || any(greaterThanEqual(sample_place, textureSize(offsets, 0)));
}

const int no_ground = 0;
const int near_ground = 1;
const int far_ground = 2;

// What a sample sees: lengths on far ground have a minus sign, even 0.
int ground_at(ivec2 sample_place) {
    if (samples_in_buffer > 0.5) return int(number_at(sample_place, 0) & 7u);
    vec4 texel = texelFetch(offsets, sample_place, 0);
    if (texel.xyz == vec3(0.0)) return no_ground;
    return floatBitsToInt(texel.w) < 0 ? far_ground : near_ground;
}

// The sample that is coloured.
ivec2 own_sample() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    if (packed_samples < 0.5) return here;
    ivec2 pixel = ivec2(gl_FragCoord.xy / float(factor));
    return ivec2(texelFetch(listed, pixel, 0).xy) + here - factor * pixel;
}

// In listed pixels there are samples of other ground.
bool is_left_out(int ground) { return packed_samples > 0.5 && ground_at(own_sample()) != ground; }

// From the corners of a pixel all of whose samples see the same ground.
SeenPlace pixel_place(out float slant) {
    ivec2 south_west = ivec2(first_sample) + factor * ivec2(gl_FragCoord.xy);
    int last = factor - 1;
    ivec2 south_east = south_west + ivec2(last, 0);
    ivec2 north_west = south_west + ivec2(0, last);
    ivec2 north_east = south_west + ivec2(last, last);
    vec4 sw, se, nw, ne;
    if (samples_in_buffer > 0.5 && factor == 2) {
        int four = four_of(south_west - ivec2(numbers_begin));
        uvec4 numbers = texelFetch(seen_numbers, four);
        vec4 lengths = uintBitsToFloat(texelFetch(seen_numbers, four + int(fours)));
        sw = vec4(offset_of(south_west, nearness_of(numbers.x)), lengths.x);
        se = vec4(offset_of(south_east, nearness_of(numbers.y)), lengths.y);
        nw = vec4(offset_of(north_west, nearness_of(numbers.z)), lengths.z);
        ne = vec4(offset_of(north_east, nearness_of(numbers.w)), lengths.w);
    } else {
        sw = seen_at(south_west);
        se = seen_at(south_east);
        nw = seen_at(north_west);
        ne = seen_at(north_east);
    }
    slant = min(min(sw.w, se.w), min(nw.w, ne.w)) * float(factor);
    SeenPlace place;
    float whole = float(factor) / float(last);
    place.offset = 0.25 * (sw.xyz + se.xyz + nw.xyz + ne.xyz);
    place.along = 0.5 * whole * (se.xyz - sw.xyz + ne.xyz - nw.xyz);
    place.up = 0.5 * whole * (nw.xyz - sw.xyz + ne.xyz - se.xyz);
    return place;
}
