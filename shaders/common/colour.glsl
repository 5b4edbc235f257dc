// Linear light, display values, and the tone curve between them.

uniform int tone;        // 0 filmic, 1 AgX, 2 neutral; 3: radiances stay what they are
uniform float punch;     // 1: AgX with more contrast and colour
uniform float exposure;  // a factor
uniform float contrast;  // a power around middle grey
uniform float toe;       // 1: two stops below it and deeper, shade keeps its share of the light

const float largest_radiance = 65000.0;  // that a half can hold, nearly

vec3 display_from_linear(vec3 c) {
    if (tone == 3) return min(c, vec3(largest_radiance));
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

const float grey = 0.18;

// The power, of stops from grey, less towards the brightest, which has so much room, and with a toe in shade.
vec3 contrasted(vec3 stops, float room) {
    const float shade = 2.0;  // stops
    vec3 deep = toe * clamp(-stops / shade, 0.0, 1.0);
    return stops * contrast / (1.0 + (contrast - 1.0) * max(clamp(stops / room, 0.0, 1.0), deep));
}

// AgX (T. Sobotka, with B. Wrensch's polynomial), in Rec. 2020: bright colours turn pale.
vec3 agx(vec3 c) {
    const mat3 rec2020_from_srgb = mat3(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113, 0.8956);
    const mat3 srgb_from_rec2020 = mat3(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
    const mat3 inset = mat3(0.856627153315983, 0.137318972929847, 0.11189821299995,
                            0.0951212405381588, 0.761241990602591, 0.0767994186031903,
                            0.0482516061458583, 0.101439036467562, 0.811302368396859);
    const mat3 outset = mat3(1.1271005818144368, -0.1413297634984383, -0.14132976349843826,
                             -0.11060664309660323, 1.157823702216272, -0.11060664309660294,
                             -0.016493938717834573, -0.016493938717834257, 1.2519364065950405);
    const float lowest = -12.47393;  // stops
    const float highest = 4.026069;
    vec3 x = log2(max(inset * (rec2020_from_srgb * c), vec3(1e-10)));
    if (contrast != 1.0) x = log2(grey) + contrasted(x - log2(grey), highest - log2(grey));
    x = clamp((x - lowest) / (highest - lowest), 0.0, 1.0);
    x = (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232;
    if (punch > 0.0) {  // its look "punchy"
        x = pow(max(x, vec3(0.0)), vec3(1.35));
        x = mix(vec3(luminance(x)), x, 1.4);
    }
    return clamp(srgb_from_rec2020 * pow(max(outset * x, vec3(0.0)), vec3(2.2)), 0.0, 1.0);
}

// PBR Neutral (Khronos Group 2024): hues stay up to bright colours, which turn pale.
vec3 neutral(vec3 c) {
    const float compressed_from = 0.76;
    float least = min(c.r, min(c.g, c.b));
    c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < compressed_from) return c;
    float room = 1.0 - compressed_from;
    float new_peak = 1.0 - room * room / (peak + room - compressed_from);
    c *= new_peak / peak;
    return mix(c, vec3(new_peak), 1.0 - 1.0 / (0.15 * (peak - new_peak) + 1.0));
}

// A filmic curve (rational fit of the ACES reference rendering, Narkowicz 2015), on a mix of
// channels and luminance so that bright sand keeps its colour.
vec3 filmic(vec3 c) {
    c *= 0.80;
    vec3 separate = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
    float l = max(luminance(c), 1e-5);
    float curve = l * (2.51 * l + 0.03) / (l * (2.43 * l + 0.59) + 0.14);
    return clamp(mix(c * (curve / l), separate, 0.7), 0.0, 1.0);
}

vec3 tone_curve(vec3 c) {
    if (tone == 3) return c;
    c *= exposure;
    if (tone == 1) return agx(c);
    if (contrast != 1.0) {
        vec3 over_grey = max(c / grey, vec3(1e-10));
        c = grey * (toe > 0.5 ? exp2(contrasted(log2(over_grey), 1e9)) : pow(over_grey, vec3(contrast)));
    }
    if (tone == 2) return neutral(c);
    return filmic(c);
}
