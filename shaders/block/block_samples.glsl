// What the four samples of a pixel see of the block, of block/seen_kind.frag.glsl.
uniform usampler2D seen;

const int surface_kind = 1;  // the others are sides

// South-west, south-east, north-west, north-east.
ivec4 seen_by_samples() {
#ifdef GL_ARB_texture_gather
    return ivec4(textureGather(seen, 2.0 * gl_FragCoord.xy / vec2(textureSize(seen, 0))).wzxy);
#else
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    return ivec4(texelFetch(seen, at, 0).r, texelFetch(seen, at + ivec2(1, 0), 0).r,
                 texelFetch(seen, at + ivec2(0, 1), 0).r, texelFetch(seen, at + ivec2(1, 1), 0).r);
#endif
}

ivec4 kinds_of(ivec4 seen_there) { return (seen_there >> 29) & 7; }

// 0 … 1
vec4 first_numbers(ivec4 seen_there) { return vec4((seen_there >> 14) & 32767) / 32767.0; }
vec4 second_numbers(ivec4 seen_there) { return vec4(seen_there & 16383) / 16383.0; }
