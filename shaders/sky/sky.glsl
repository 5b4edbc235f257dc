// The clear sky in a direction of view (unit vector), without the sun's disc and its glare. Needs common/light.glsl before it.
vec3 sky(vec3 view) {
    if (atmosphere > 0.5) return scattered_sky(view);
    vec3 horizon = haze_towards(view);
    float height_of_view = clamp(view.z, 0.0, 1.0);
    height_of_view *= height_of_view / (height_of_view + 0.04);  // no crease at the horizon
    vec3 colour_there = mix(horizon, zenith_colour, 1.0 - exp(-14.0 * height_of_view));
    float near_sun = max(dot(view, to_sun), 0.0);
    near_sun *= near_sun; near_sun *= near_sun; near_sun *= near_sun;
    return colour_there + glow_colour * 0.35 * near_sun;
}
