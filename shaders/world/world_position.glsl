// Where samples, and pixels of them, see the ground.
uniform vec2 first_sample;  // of the lower left pixel
uniform int factor;         // samples along each side of a pixel
uniform float visibility_in_buffer;  // 1: visibility is in visibility_buffer, 0: in offsets
uniform sampler2D offsets;  // of visible points from the eye, and lengths, by world/world_visibility.frag.glsl; none: 0
uniform float packed_samples;  // 1: colours samples of listed pixels, which lie side by side
uniform sampler2D listed;   // the first sample of each

// A place on the ground, and how it changes to the next sample or pixel along both sides of the picture.
struct SurfacePoint {
    vec3 offset;  // from the eye
    vec3 along;
    vec3 up;
};

// The ground's slope there, as it is drawn.
float fall_at(SurfacePoint position) {
    vec3 up = cross(position.along, position.up);
    return length(up.xy) / max(abs(up.z), 1e-20);
}

// See GroundRasteriser::rasterise().
uniform usamplerBuffer visibility_buffer;  // by quads of samples
uniform vec2 buffer_origin;  // the sample that has the first of them
uniform float quads_per_row;
uniform float quads;  // of reversed z, after which those of lengths begin
uniform vec2 target_begin;  // the picture's sample that is the target's first
uniform vec3 first_ray;  // over the reversed_z of what it meets
uniform vec3 ray_rightward;
uniform vec3 ray_upward;

// Where a sample's four numbers are: of two samples in a row, and of the two over them.
int quad_index(ivec2 position) { return (position.y >> 1) * int(quads_per_row) + (position.x >> 1); }

uint visibility_word(ivec2 sample_coord, int first_quad) {
    ivec2 position = sample_coord - ivec2(buffer_origin);
    uvec4 quad = texelFetch(visibility_buffer, first_quad + quad_index(position));
    uvec2 row = (position.y & 1) == 0 ? quad.xy : quad.zw;
    return (position.x & 1) == 0 ? row.x : row.y;
}

float reversed_z_of(uint number) { return uintBitsToFloat(number & ~7u); }
float reversed_z_at(ivec2 sample_coord) { return reversed_z_of(visibility_word(sample_coord, 0)); }

// Offset of a sample's visible point from the eye.
vec3 offset_of(ivec2 sample_coord, float reversed_z) {
    vec2 in_picture = vec2(sample_coord) + target_begin;
    vec3 ray = first_ray + in_picture.x * ray_rightward + in_picture.y * ray_upward;
    return ray * (reversed_z > 0.0 ? 1.0 / reversed_z : 0.0);
}

vec4 visibility_at(ivec2 sample_coord) {
    if (visibility_in_buffer > 0.5)
        return vec4(offset_of(sample_coord, reversed_z_at(sample_coord)), uintBitsToFloat(visibility_word(sample_coord, int(quads))));
    vec4 texel = texelFetch(offsets, sample_coord, 0);
    return vec4(texel.xyz, abs(texel.w));
}

// Whether nothing is known of a sample; of those in visibility_buffer all are that stand beside the tile's.
bool is_beyond(ivec2 sample_coord) {
    if (visibility_in_buffer > 0.5) return false;
    return any(lessThan(sample_coord, ivec2(0))) || any(greaterThanEqual(sample_coord, textureSize(offsets, 0)));
}

const int no_ground = 0;
const int near_ground = 1;
const int far_ground = 2;

// What a sample sees: lengths on far ground have a minus sign, even 0.
int ground_at(ivec2 sample_coord) {
    if (visibility_in_buffer > 0.5) return int(visibility_word(sample_coord, 0) & 7u);
    vec4 texel = texelFetch(offsets, sample_coord, 0);
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
bool is_other_ground(int ground) { return packed_samples > 0.5 && ground_at(own_sample()) != ground; }

// From the corners of a pixel all of whose samples see the same ground.
SurfacePoint pixel_surface_point(out float slant) {
    ivec2 south_west = ivec2(first_sample) + factor * ivec2(gl_FragCoord.xy);
    int last = factor - 1;
    ivec2 south_east = south_west + ivec2(last, 0);
    ivec2 north_west = south_west + ivec2(0, last);
    ivec2 north_east = south_west + ivec2(last, last);
    vec4 sw, se, nw, ne;
    if (visibility_in_buffer > 0.5 && factor == 2) {
        int quad = quad_index(south_west - ivec2(buffer_origin));
        uvec4 numbers = texelFetch(visibility_buffer, quad);
        vec4 lengths = uintBitsToFloat(texelFetch(visibility_buffer, quad + int(quads)));
        sw = vec4(offset_of(south_west, reversed_z_of(numbers.x)), lengths.x);
        se = vec4(offset_of(south_east, reversed_z_of(numbers.y)), lengths.y);
        nw = vec4(offset_of(north_west, reversed_z_of(numbers.z)), lengths.z);
        ne = vec4(offset_of(north_east, reversed_z_of(numbers.w)), lengths.w);
    } else {
        sw = visibility_at(south_west);
        se = visibility_at(south_east);
        nw = visibility_at(north_west);
        ne = visibility_at(north_east);
    }
    slant = min(min(sw.w, se.w), min(nw.w, ne.w)) * float(factor);
    SurfacePoint position;
    float whole = float(factor) / float(last);
    position.offset = 0.25 * (sw.xyz + se.xyz + nw.xyz + ne.xyz);
    position.along = 0.5 * whole * (se.xyz - sw.xyz + ne.xyz - nw.xyz);
    position.up = 0.5 * whole * (nw.xyz - sw.xyz + ne.xyz - se.xyz);
    return position;
}
