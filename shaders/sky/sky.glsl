// The clear sky in a direction of view (unit vector). Needs common/light.glsl before it.
vec3 sky(vec3 view) {
    if (atmosphere > 0.5) {
        // Within the disc a share of the sun's irradiance over its solid angle: any display ends below it.
        const float radius = 0.004675;
        float disc = 1.0 - smoothstep(0.94 * radius, 1.06 * radius, length(view - to_sun));
        return scattered_sky(view) + glare(view) + 200.0 * disc * sun_light;
    }
    vec3 horizon = haze_towards(view);
    float height_of_view = clamp(view.z, 0.0, 1.0);
    height_of_view *= height_of_view / (height_of_view + 0.04);  // no crease at the horizon
    vec3 colour_there = mix(horizon, zenith_colour, 1.0 - exp(-14.0 * height_of_view));
    float near_sun = max(dot(view, to_sun), 0.0);
    near_sun *= near_sun; near_sun *= near_sun; near_sun *= near_sun;
    return colour_there + glow_colour * 0.35 * near_sun;
}
