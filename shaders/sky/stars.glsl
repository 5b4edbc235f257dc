// Stars by chance, as many and as unequal as the real ones: each magnitude has three times as many as the one before. Needs
// common/noise.glsl before it.
uniform float stars;  // 1: they are seen
uniform float pixel;  // its angle, radians

// In a direction of view (unit vector): of one face of a cube around the eye, a star in most of its squares.
vec3 starlight(vec3 view) {
    const float squares = 70.0;
    vec3 size = abs(view);
    float largest = max(size.x, max(size.y, size.z));
    int face = size.x == largest ? (view.x > 0.0 ? 0 : 1) : size.y == largest ? (view.y > 0.0 ? 2 : 3) : 4;
    vec2 on_face = (face < 2 ? view.yz : face < 4 ? view.xz : view.xy) / largest;
    vec2 scaled = squares * (0.5 + 0.5 * on_face);
    ivec2 square = ivec2(floor(scaled)) + 1000 * face;
    vec2 centre = 0.2 + 0.6 * vec2(hash(square), hash(square + ivec2(311, 57)));
    vec2 off = (fract(scaled) - centre) * (2.0 / squares) / (0.62 * pixel);
    float rank = max(hash(square + ivec2(91, 503)), 0.01);
    float brightness = 0.008 / rank;  // so that N(brighter than b) falls as 1/b
    vec3 tint = mix(vec3(1.0, 0.82, 0.62), vec3(0.75, 0.86, 1.0), hash(square + ivec2(17, 5)));
    return tint * (brightness * exp(-dot(off, off)) * smoothstep(0.02, 0.25, view.z));
}
