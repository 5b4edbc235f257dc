// Blown sand between the eye and the visible surface; see streamers/puff.frag.glsl.
uniform float streamers;         // 1: there is some
uniform sampler2D streamer_map;  // sums of optical depths times radiances, and of optical depths

vec3 through_streamers(vec3 light, ivec2 pixel) {
    if (streamers < 0.5) return light;
    vec4 depths = texelFetch(streamer_map, clamp(pixel, ivec2(0), textureSize(streamer_map, 0) - 1), 0);
    float through = exp(-depths.a);
    float scattered = depths.a > 1e-3 ? (1.0 - through) / depths.a : 1.0 - 0.5 * depths.a;
    return light * through + depths.rgb * scattered;
}
