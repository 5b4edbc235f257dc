// The colour of the block's cut sides: soil, or layers of sand as in a dune's trench.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/noise.glsl"
#include "bed/bed.glsl"
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "block/spade_cut.glsl"

uniform float base;
uniform float figure;  // 1: plain and grey
uniform float clear;   // 1: and light, with an outline
uniform float side_line;  // its width, block lengths
uniform float upright;    // of a height, how much of it is seen
uniform float rock;
uniform float soil;  // 1: cut by a spade
uniform float plaster;  // 1: plain
uniform float watery;  // 1: of a bed with water
uniform float turbidity;  // of all the water: 0 clear … 1 muddy
uniform float clarity;  // depth of water at which the bed is half hidden, block lengths
uniform vec2 height_range;  // of all grounds and surfaces

in vec2 outward;
vec3 cut_point;

// Sets of cross-beds: thick layers that undulate, each filled with thin laminae of its own dip.
struct Layers {
    vec3 albedo;
    float lamina;  // −1 … 1
};

Layers layers_at(float along) {
    float undulation = 0.55 * value_noise(vec2(along * 2.3, 4.5)) + 0.22 * value_noise(vec2(along * 7.1, 8.5));
    float sets = cut_point.z * 52.0 + undulation;
    float set_number = floor(sets);
    float within = sets - set_number;
    ivec2 set_key = ivec2(int(set_number), 17);
    float dip = 0.35 * (hash(set_key) - 0.5);
    float laminae = (cut_point.z + dip * along) * 260.0 + 0.7 * value_noise(vec2(along * 9.0, set_number));
    float lamina = value_noise(vec2(laminae, set_number * 7.0));
    float set_tone = mix(hash(set_key + ivec2(1, 5)), hash(set_key + ivec2(0, 5)), smoothstep(0.0, 0.10, 1.0 - within));
    float speck = value_noise(vec2(along, cut_point.z) * 700.0);
    float tone = 0.26 + 0.34 * set_tone + 0.09 * lamina + 0.20 * (speck - 0.5) - 0.10 * smoothstep(0.90, 1.0, within);
    vec3 albedo = mix(vec3(0.54, 0.335, 0.175), vec3(0.74, 0.515, 0.30), clamp(tone, 0.0, 1.0));
    albedo = mix(albedo, mix(vec3(0.36, 0.215, 0.135), vec3(0.60, 0.43, 0.295), clamp(tone, 0.0, 1.0)), rock);
    return Layers(albedo, lamina);
}

// Smooth plaster, in the ground's tone.
vec3 plaster_albedo() {
    vec3 ground = mix(mix(sand_trough, sand_crest, 0.5), vec3(0.56, 0.40, 0.25), rock);
    return mix(vec3(luminance(ground)), ground, 0.25) * 1.2;
}

// Across the nearest of eight directions to the face's, so that steps along a rim do not fold what is drawn on them.
vec2 along_face() {
    vec2 size = abs(outward);
    const float steep = 2.414;  // tangent of 67.5 degrees
    if (size.x > steep * size.y) return vec2(0.0, sign(outward.x));
    if (size.y > steep * size.x) return vec2(-sign(outward.y), 0.0);
    return 0.7071 * vec2(-sign(outward.y), sign(outward.x));
}

// The bed that is seen through the water of a cut, lit through what stands over it; light is gathered where waves focus it.
// `slant`: ratio of a length there to its projection in the view.
vec3 bed_below(vec2 at, vec3 down, float standing, float slant) {
    float lumps = shown(30.0 * slant) * value_noise(at * 30.0) + 0.7 * shown(90.0 * slant) * value_noise(at * 90.0 + 7.0);
    vec3 albedo = soaking * silt() * (1.0 + 0.16 * lumps);
    float waves = 1.6 / max(standing, 0.002);
    float focus = 1.0 - abs(value_noise(at * waves));
    focus *= focus;
    return albedo * down * transmitted(1.1 * standing / clarity, turbidity) * (0.95 + 0.16 * shown(waves * slant) * (focus * focus - 0.4));
}

// Water, cut through as behind the pane of a flume: the eye's ray, bent at the pane, goes on to the bed, which is taken to
// be level behind it. Lengths are those drawn, and so is `clarity`: over the depth they are the true ones' share.
vec3 water_cut(vec3 to_eye, float sun, float below_surface, float above_bed) {
    const float water_index = 1.33;
    const float least_fall = 0.02;  // of a ray: beyond, it does not come to the bed
    vec3 pane = vec3(outward, 0.0);
    vec3 down = sun_light * max(to_sun.z, 0.15) + sky_light;
    vec3 ray = refract(-to_eye, pane, 1.0 / water_index);
    float standing = below_surface + above_bed;
    // A ray that rises is mirrored by the surface.
    float way = (above_bed + (ray.z > 0.0 ? 2.0 * below_surface : 0.0)) / max(abs(ray.z), least_fall);
    vec3 left = transmitted(way / clarity, turbidity);
    vec3 lit = studio * (1.0 - turbidity) * vec3(0.062, 0.074, 0.084);  // from all around, as through a tank of glass
    vec3 body = (water_body_colour(turbidity) + lit) * (1.4 * down * transmitted(1.1 * below_surface / clarity, turbidity) + 0.3 * sun_light * sun);
    vec3 light = mix(body, bed_below(cut_point.xy + way * ray.xy, down, standing, 1.0 / max(abs(ray.z), least_fall)), left);
    float facing = max(dot(pane, to_eye), 0.0);
    float grazing = (1.0 - facing) * (1.0 - facing);
    float fresnel = 0.03 + 0.97 * grazing * grazing * (1.0 - facing);
    vec3 mirrored = reflect(-to_eye, pane);
    vec3 around = mirrored.z < 0.0 ? vec3(0.45, 0.38, 0.29) * down : studio > 0.5 ? studio_around(mirrored) : sky(mirrored);
    light = mix(light, around, fresnel);
    // Its edge leads light, and the bed's is dark where the two meet.
    float brim = exp(-below_surface * pixels * 0.7);
    float foot = exp(-above_bed * pixels * 0.7);
    light *= 1.0 - 0.35 * foot;
    return mix(light, 0.60 * sky_light + 0.45 * sun_light, 0.55 * brim);
}

// Of a figure whose sides are plain: two light tones, and thin lines along the ground, the foot and the block's corners.
vec3 plain_side(float ground, float surface) {
    float tone = 0.875 + 0.055 * dot(normalize(to_sun.xy + vec2(1e-6, 0.0)), outward);
    vec3 face = vec3(tone) * vec3(1.0, 0.995, 0.985);
    if (cut_point.z > ground && surface > ground) face = vec3(0.74, 0.84, 0.92);
    float top = max(surface, ground) - cut_point.z;
    vec2 to_corner = 0.5 * extent - abs(cut_point.xy);
    float corner = abs(outward.x) > 0.5 ? to_corner.y : to_corner.x;
    float within = min(min(top, cut_point.z - base) * upright, 1.6 * corner) / side_line;
    return mix(vec3(0.28), face, smoothstep(0.6, 1.2, within));
}

// Display values at a point. `heights`: of the ground and of the surface over it, 0 … 1 over their range.
vec3 side_colour(vec3 point, vec2 heights) {
    cut_point = point;
    vec2 levels = mix(height_range.xx, height_range.yy, heights);
    float ground = levels.x;
    float surface = levels.y;  // above the ground where water stands on it
    if (figure > 0.5 && clear > 0.5) return display_from_linear(linear_from_display(plain_side(ground, surface)));
    float depth = ground - cut_point.z;
    vec3 normal = vec3(outward, 0.0);
    vec3 to_eye = direction_to_eye(cut_point);
    float level_sun = max(dot(normal, to_sun), 0.0);
    vec3 albedo;
    float lamina = 0.0;
    float rim;
    if (plaster > 0.5) {
        albedo = plaster_albedo();
        rim = 1.0;
    } else if (soil > 0.5) {
        vec2 along = along_face();
        vec2 at = vec2(dot(cut_point.xy, along), cut_point.z);
        Cut cut = sand_cut(at, depth, watery, smoothstep(0.0, 0.01, surface - ground));
        if (rock > 0.0) {
            Cut earth = earth_cut(at, depth);
            cut = Cut(mix(cut.albedo, earth.albedo, rock), mix(cut.slope, earth.slope, rock));
        }
        albedo = cut.albedo;
        normal = normalize(normal - vec3(cut.slope.x * along, cut.slope.y));
        rim = 1.0;
    } else {
        Layers layers = layers_at(cut_point.x + cut_point.y);
        albedo = layers.albedo;
        lamina = layers.lamina;
        rim = 1.0 - 0.22 * exp(-depth * 160.0);  // the damp edge under the surface
    }
    float sun = max(dot(normal, to_sun), 0.0);
    float above_ground = clamp((cut_point.z - base) / 0.10, 0.0, 1.0);
    float open = (studio > 0.5 ? 0.40 : 0.34) + 0.24 * above_ground;  // half the sky, less near the ground
    vec3 bounce = (studio > 0.5 ? 0.60 : 0.42) * (sun_light * max(to_sun.z, 0.15) + 0.5 * sky_light) * (studio > 0.5 ? vec3(0.66) : vec3(0.78, 0.62, 0.44)) *
                  (0.35 + 0.65 * max(0.5 + 0.5 * dot(normalize(to_sun.xy), outward), sun));
    vec3 light = albedo * rim * (sun_light * 0.85 * sun + sky_light * open * (1.0 + 0.7 * normal.z) + bounce * (1.0 - 0.7 * normal.z));
    if (cut_point.z > ground && surface > ground) {  // water, cut through
        float below = surface - cut_point.z;
        if (soil > 0.5 || plaster > 0.5) {
            light = water_cut(to_eye, level_sun, below, cut_point.z - ground);
        } else {
            float up = below / (surface - ground);
            light = mix(water_body_colour(turbidity) * 1.6, vec3(0.10, 0.20, 0.22), 0.5 - 0.4 * up) * (sun_light * (0.35 + 0.5 * sun) + sky_light);
        }
    }
    vec3 scenic = tone_curve(with_haze(light, cut_point, -to_eye));
    float grey = 0.42 + 0.25 * sun + 0.05 * lamina;
    return display_from_linear(mix(scenic, vec3(grey) * vec3(1.0, 0.97, 0.93), figure));
}
