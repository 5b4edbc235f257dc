// The light that a deep body of water sends back: more in a studio, where light comes from all sides. `turbidity`: 0 clear … 1 muddy.
// Needs common/light.glsl before it.
uniform float blue_green;  // 1: tinted as a clear sea, else dark as streams and ponds are

vec3 water_body_colour(float turbidity) {
    vec3 clear = blue_green > 0.5 ? vec3(0.012, 0.055, 0.066) : vec3(0.014, 0.030, 0.028) + studio * vec3(0.018, 0.014, 0.018);
    vec3 muddy = mix(vec3(0.250, 0.172, 0.102), vec3(0.232, 0.172, 0.114), studio);  // less golden, as the ground there
    return mix(clear, muddy, turbidity);
}

// What is left of light after a way through the water (Beer–Lambert), in units of `clarity`: clear
// water takes the red first, silt the blue.
vec3 transmitted(float way, float turbidity) {
    vec3 clear = blue_green > 0.5 ? vec3(1.75, 0.62, 0.50) : vec3(1.10, 0.93, 0.97);
    vec3 absorbed = mix(clear, vec3(0.62, 0.85, 1.45), turbidity);
    return exp(-0.693 * way * absorbed);
}
