#version 330 core
// A puff of blown sand: a square of the picture around it, and what light it scatters to the eye.
#include "common/snap.glsl"
#include "common/light.glsl"

uniform vec3 right;    // of the camera, over half of the picture at depth 1
uniform vec3 up;
uniform vec3 forward;
uniform vec2 lens;     // lengths of right and up
uniform vec3 aside;    // of the eye, of the point that sees
uniform vec2 shear;    // where in the picture of a pinhole its middle is seen
uniform vec3 sand_crest;

in vec4 middle;  // from the eye; density
in vec4 along;   // first axis, and the spread along it
in vec4 across;  // other spreads; shares of sun and sky

flat out vec3 to_unit_x;  // to where the puff is a ball of radius 1
flat out vec3 to_unit_y;
flat out vec3 to_unit_z;
flat out vec3 unit_middle;
flat out vec4 scattered;  // radiance of a thick one, and density

// Share of light that grains send on at an angle (Henyey & Greenstein 1941), times pi.
float scattering(float cosine, float g) {
    float base = 1.0 + g * g - 2.0 * g * cosine;
    return 0.25 * (1.0 - g * g) * inversesqrt(base * base * base);
}

// Where a way from the puff's middle goes in the picture; `at` as a pinhole's picture has it.
vec2 in_picture(vec3 way, float depth, vec2 at) {
    return (vec2(dot(way, right), dot(way, up)) / (lens * lens) - at * dot(way, forward)) / depth;
}

void main() {
    vec3 second = normalize(vec3(-along.y, along.x, 0.0));
    vec3 third = cross(along.xyz, second);
    to_unit_x = along.xyz / along.w;
    to_unit_y = second / across.x;
    to_unit_z = third / across.y;
    vec3 position = middle.xyz - aside;
    unit_middle = vec3(dot(to_unit_x, position), dot(to_unit_y, position), dot(to_unit_z, position));

    float depth = dot(position, forward);
    vec2 at = vec2(dot(position, right), dot(position, up)) / (lens * lens) / depth;
    vec2 a = in_picture(along.xyz * along.w, depth, at);
    vec2 b = in_picture(second * across.x, depth, at);
    vec2 c = in_picture(third * across.y, depth, at);
    // Axes of the ellipse that it shows as.
    float xx = a.x * a.x + b.x * b.x + c.x * c.x;
    float yy = a.y * a.y + b.y * b.y + c.y * c.y;
    float xy = a.x * a.y + b.x * b.y + c.x * c.y;
    float mean = 0.5 * (xx + yy);
    float apart = sqrt(max(0.25 * (xx - yy) * (xx - yy) + xy * xy, 1e-30));
    vec2 long_axis = normalize(abs(xx - yy) > abs(2.0 * xy) * 1e-4 || abs(xy) > 1e-20 ? (xx > yy ? vec2(0.5 * (xx - yy) + apart, xy) : vec2(xy, 0.5 * (yy - xx) + apart)) : vec2(1.0, 0.0));
    vec2 longer = long_axis * sqrt(mean + apart);
    vec2 shorter = vec2(-long_axis.y, long_axis.x) * sqrt(max(mean - apart, 0.0));
    const float reach = 2.8;
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    gl_Position = snapped(vec4(at - shear + reach * (corner.x * longer + corner.y * shorter), 0.0, 1.0));

    vec3 view = normalize(middle.xyz);
    float cosine = dot(view, to_sun);
    float share = 0.65 * scattering(cosine, 0.7) + 0.35 * scattering(cosine, -0.35);
    vec3 grains = sqrt(sand_crest);  // light passes them and is mirrored, more than by a bed of them
    vec3 ground = sand_crest * (sun_light * max(to_sun.z, 0.0) + sky_light);
    vec3 light = grains * (1.6 * in_air * sun_light * (share * across.z) + across.w * (0.55 * in_air * sky_light + 0.25 * ground));
    vec3 haze = haze_along(view);
    scattered = vec4(mix(haze, light, air_left(length(middle.xyz))), middle.w);
}
