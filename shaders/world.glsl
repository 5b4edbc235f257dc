// Sand to the horizon, shaded a sample at a time. Needs colour.glsl, light.glsl, noise.glsl, oren_nayar.glsl,
// bed.glsl and ground.glsl before it.
uniform vec2 whole_eye;       // the eye's place, not reduced to one period
uniform float sand_grain;     // how much of it is seen
uniform float ripple_length;  // block lengths

in vec3 offset;  // from the eye
in vec4 air;
uniform sampler2D albedo_map;  // roots, of shade_albedo.frag.glsl
out vec4 colour;

vec2 bed_place() { return (eye.xy + offset.xy) / extent + 0.5; }

// Unevenness of the sand, as fine as is seen at any distance: two octaves of noise in turn.
float grain(float footprint) {
    float octave = log2(max(3.0 * footprint, 1e-9));
    float whole = floor(octave);
    vec2 at = (whole_eye + offset.xy) * exp2(-whole);
    return mix(value_noise(at), value_noise(0.5 * at + 31.7), octave - whole);
}

vec3 sand_albedo(vec2 place, float brighter) {
    vec3 root = texture(albedo_map, place).rgb;
    return root * root * (1.0 + brighter);
}

// What the eye gets of light that leaves the ground.
vec4 seen(vec3 light, vec3 to_eye) {
    light = light * air.a + air.rgb + glare(-to_eye);
    return vec4(display_from_linear(tone_curve(light)), 1.0);
}
