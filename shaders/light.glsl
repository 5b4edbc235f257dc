// The light of a scenic view; see render/light.h.
uniform vec3 to_sun;
uniform vec3 sun_light;
uniform vec3 sky_light;
uniform vec3 sky_lean;
uniform sampler2D sky_map;  // radiances times pi; see Light

// Aerial perspective: depth_plane gives 0 at the block's nearest corner and 1 at its farthest.
uniform vec4 depth_plane;
uniform float haze_log;  // log(1 − haze) of the far corner

// The clear sky in a direction of view (unit vector).
vec3 sky(vec3 view) {
    float across = max(length(view.xy) * length(to_sun.xy), 1e-6);
    float azimuth = acos(clamp(dot(view.xy, to_sun.xy) / across, -1.0, 1.0)) / 3.14159265;
    float elevation = sqrt(clamp(asin(clamp(view.z, 0.0, 1.0)) / 1.57079633, 0.0, 1.0));
    vec2 size = vec2(textureSize(sky_map, 0));
    vec2 at = (vec2(azimuth, elevation) * (size - 1.0) + 0.5) / size;
    return texture(sky_map, at).rgb;
}

// What far things fade into in a direction of view.
vec3 haze_towards(vec3 view) { return sky(vec3(view.xy, 0.0)); }

vec3 with_haze(vec3 colour, vec3 point, vec3 view) {
    float depth = max(dot(depth_plane.xyz, point) + depth_plane.w, 0.0);
    return mix(haze_towards(view), colour, exp(haze_log * depth * depth));
}
