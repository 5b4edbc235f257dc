// The light of a scenic view; see render/light.h.
uniform vec3 to_sun;
uniform vec3 sun_light;
uniform vec3 sky_light;
uniform vec3 haze_colour;
uniform vec3 glow_colour;
uniform vec3 zenith_colour;

// Aerial perspective: depth_plane gives 0 at the block's nearest corner and 1 at its farthest.
uniform vec4 depth_plane;
uniform float haze_log;  // log(1 − haze) of the far corner

// What far things fade into in a direction of view (unit vector).
vec3 haze_towards(vec3 view) {
    float towards_sun = 0.5 + 0.5 * dot(normalize(view.xy + vec2(1e-6, 0.0)), normalize(to_sun.xy + vec2(1e-6, 0.0)));
    towards_sun *= towards_sun;
    return mix(haze_colour, glow_colour, towards_sun * towards_sun);
}

vec3 with_haze(vec3 colour, vec3 point, vec3 view) {
    float depth = max(dot(depth_plane.xyz, point) + depth_plane.w, 0.0);
    return mix(haze_towards(view), colour, exp(haze_log * depth * depth));
}
