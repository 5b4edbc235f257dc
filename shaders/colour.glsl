// Linear light, display values, and the tone curve between them.

vec3 display_from_linear(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(max(c, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, vec3(lessThan(c, vec3(0.0031308))));
}

vec3 linear_from_display(vec3 c) {
    vec3 high = pow((c + 0.055) / 1.055, vec3(2.4));
    return mix(high, c / 12.92, vec3(lessThan(c, vec3(0.04045))));
}

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// A filmic curve (rational fit of the ACES reference rendering, Narkowicz 2015), on a mix of
// channels and luminance so that bright sand keeps its colour.
vec3 tone_curve(vec3 c) {
    c *= 0.80;
    vec3 separate = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
    float l = max(luminance(c), 1e-5);
    float curve = l * (2.51 * l + 0.03) / (l * (2.43 * l + 0.59) + 0.14);
    return clamp(mix(c * (curve / l), separate, 0.7), 0.0, 1.0);
}
