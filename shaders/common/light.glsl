// The light of a scenic view; see render/light.h.
uniform vec3 to_sun;
uniform vec3 sun_light;
uniform float visible_sun;  // share of its light that reaches the eye
uniform float bloom;     // around its disc, see glare()
uniform vec3 sky_light;
uniform float in_air;    // of both, what things in the air get; 1 on the ground
uniform vec3 haze_colour;
uniform vec3 glow_colour;
uniform vec3 zenith_colour;
uniform float atmosphere;   // 1: the sky is that of sky_map
uniform float studio;       // 1: there is no sky, but a neutral table and the wall behind it
uniform sampler2D sky_map;  // radiances times pi; see Light
// How much more of it a slope gets; see Light::sky_lean.
uniform vec3 sky_lean_x;
uniform vec3 sky_lean_xx;
uniform vec3 sky_lean_t;
uniform vec3 sky_lean_tx;

// Aerial perspective: depth_plane gives 0 at the block's nearest corner and 1 at its farthest.
uniform vec4 depth_plane;
uniform float haze_log;  // log(1 − haze) of the far corner; −1 by distance
// The same by distance, where the air's visibility is known.
uniform float extinction;  // per block length, of green light; below 0: not known
uniform vec3 haze_bands;   // red, green and blue against it, over endless ground
uniform vec3 haze_eye;
uniform float shaded_height;  // to which shadows of the ground fill the air with shade, block lengths; 0: not known

// Of sky_map at the cosine of an angle from the sun, over the horizon, and at the sine of an elevation; rows below 1.2 degrees
// are seen through the whole air.
vec3 scattered_sky(float towards_sun, float height) {
    float azimuth = sqrt(acos(clamp(towards_sun, -1.0, 1.0)) / 3.14159265);
    float elevation = sqrt(asin(clamp(height, 0.021, 1.0)) / 1.57079633);
    vec2 size = vec2(textureSize(sky_map, 0));
    return texture(sky_map, (vec2(azimuth, elevation) * (size - 1.0) + 0.5) / size).rgb;
}

// In a direction of view (unit vector).
vec3 scattered_sky(vec3 view) {
    float across = max(length(view.xy) * length(to_sun.xy), 1e-6);
    return scattered_sky(dot(view.xy, to_sun.xy) / across, view.z);
}

// Light of the sun that the eye, or a lens, scatters around it: far around, and a bloom close to the disc, which together fall
// with the square and the cube of the angle (Vos & van den Berg 1999, the CIE's equation of disability glare).
vec3 glare(vec3 view) {
    const float disc2 = 2.2e-5;       // its radius squared
    const float farthest2 = 0.04;
    vec3 off = view - to_sun;
    float off2 = dot(off, off);
    float left = max(1.0 - off2 / farthest2, 0.0);
    float close = bloom * left * left / ((off2 + disc2) * sqrt(off2 + disc2));
    return sun_light * (visible_sun * (0.00015 / (off2 + 0.0002) + close));
}

// What far things fade into in a direction of view (unit vector).
vec3 haze_towards(vec3 view) {
    if (atmosphere > 0.5) return scattered_sky(vec3(view.xy, 0.0));
    float towards_sun = 0.5 + 0.5 * dot(normalize(view.xy + vec2(1e-6, 0.0)), normalize(to_sun.xy + vec2(1e-6, 0.0)));
    towards_sun *= towards_sun;
    return mix(haze_colour, glow_colour, towards_sun * towards_sun);
}

// The same along a way that may lead down: the horizon's at the same angle to the sun, since air scatters by that.
vec3 haze_along(vec3 way) {
    if (atmosphere > 0.5) return scattered_sky(dot(way, to_sun) / (length(way) * max(length(to_sun.xy), 0.02)), 0.0);
    return haze_towards(vec3(normalize(way.xy + 1e-6 * to_sun.xy), 0.0));
}

// The same before ground that gets a share of the sun: the last of the way to what is shaded leads through the same shade, where
// the air has but the sky's light.
vec3 haze_before(vec3 way, float sun) {
    const float of_sun = 0.7;
    float fall = max(length(way) * (to_sun.z / max(length(to_sun.xy), 1e-3)), abs(way.z));
    float shaded = min(shaded_height / max(fall, 1e-6), 1.0);
    return haze_along(way) * (1.0 - of_sun * shaded * (1.0 - sun));
}

// Share of light that is left after a way through the air near the ground.
vec3 air_left(float way) { return exp(-max(extinction, 0.0) * way * haze_bands); }

// 0 at the nearest corner of the block, 1 at the farthest; the root of the optical depth where haze goes by distance.
float haze_depth(vec3 point) {
    if (extinction >= 0.0) return sqrt(extinction * distance(haze_eye, point));
    return max(dot(depth_plane.xyz, point) + depth_plane.w, 0.0);
}

vec3 with_haze(vec3 colour, vec3 point, vec3 view) {
    float depth = haze_depth(point);
    return mix(haze_towards(view), colour, exp(haze_log * depth * depth));
}
