// The disc of the sun, or of the moon, as a camera shows it. Needs common/light.glsl and common/noise.glsl before it.
uniform float disc_brightness;  // the most that it has of the sun's irradiance over its solid angle

const float disc_radius = 0.004675;

struct Disc {
    float cover;  // share of the pixel
    vec3 light;   // it sends there
};

// Behind what lets a share `through`, in a direction of view (unit vector) that moves by `across` and `down` from pixel to pixel.
// What covers a pixel in part has to be mixed with the sky as the picture shows both: light so strong, tone-curved as a mean,
// is white wherever there is a little of it, and its edge a staircase.
Disc sun_disc(vec3 view, vec3 across, vec3 down, float through, bool moon) {
    Disc disc = Disc(0.0, vec3(0.0));
    vec3 off = view - to_sun;
    float away = length(off);
    float pixel_here = length(vec2(dot(off, across), dot(off, down))) / max(away, 1e-7);
    disc.cover = smoothstep(-1.0, 1.0, (disc_radius - away) / max(pixel_here, 1e-7));
    float share = min(away / disc_radius, 1.0);
    float up = sqrt(1.0 - share * share);
    if (moon) {  // evenly bright, with maria; as eyes see it, not as a picture so long exposed
        vec2 east = normalize(vec2(to_sun.y, -to_sun.x) + vec2(1e-6, 0.0));
        vec3 north = cross(to_sun, vec3(-east, 0.0));
        vec2 at = vec2(dot(off.xy, east), dot(off, north)) / disc_radius;
        float maria = smoothstep(-0.25, 0.45, 0.7 * value_noise(1.7 * at + 5.3) + 0.3 * value_noise(4.1 * at + 1.7));
        disc.light = through * vec3(2.3, 2.25, 2.1) * (1.0 - 0.5 * maria) * (0.85 + 0.15 * up);
    } else {  // darker towards the limb, blue light more
        vec3 limb = 1.0 - vec3(0.48, 0.58, 0.74) * (1.0 - up);
        disc.light = sun_light * limb * min(200.0 * through, disc_brightness);
    }
    return disc;
}
