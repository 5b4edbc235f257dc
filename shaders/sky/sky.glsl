// What water mirrors in a studio: the wall, bright windows all around, which end towards the ceiling, and the lamp.
vec3 studio_around(vec3 view) {
    vec3 wall = mix(haze_colour, zenith_colour, smoothstep(0.0, 0.9, view.z));
    float windows = 1.0 - smoothstep(0.20, 0.98, view.z);
    float lamp = smoothstep(0.92, 0.975, dot(view, to_sun));
    return wall + 2.1 * sky_light * vec3(0.72, 0.97, 1.28) * windows * (1.0 + 0.4 * view.x - 0.3 * view.y) + 8.0 * sun_light * lamp;
}

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
