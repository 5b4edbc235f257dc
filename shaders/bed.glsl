// What is known of the bed at a place (0 … 1): the lighting texture of render/lighting.h.
uniform sampler2D lighting_map;
uniform sampler2D value_map;  // palette places
uniform float marks;          // 1: some cells stand out
uniform sampler2D mark_map;   // 0 … 1: how much a cell stands out
uniform sampler2D uncoloured_map;  // 1: the cell has no palette place
uniform vec2 extent;          // of the block

uniform vec3 eye;        // perspective
uniform vec3 eye_axis;   // towards the eye, for views without perspective
uniform float parallel;  // 1: without perspective

struct BedPoint {
    vec3 normal;
    float sun;
    float sky;
};

BedPoint bed_point(vec2 place) {
    vec4 texel = texture(lighting_map, place);
    vec2 slope = texel.xy * (65535.0 / 32767.0) - 1.0;
    BedPoint point;
    point.normal = vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
    point.sun = texel.z;
    point.sky = texel.w;
    return point;
}

vec3 direction_to_eye(vec3 point) { return mix(normalize(eye - point), eye_axis, parallel); }

vec3 marked(vec3 albedo, vec2 place) {
    if (marks < 0.5) return albedo;
    return mix(albedo, vec3(0.030, 0.120, 0.330), texture(mark_map, place).r);
}
