#version 330 core
// As bed/shade_scenic.frag.glsl, with water over the bed: wet ground is darker and glossier, the water
// tints it by its depth, mirrors the sky and foams where it shoots (Froude number over 1).
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "sky/sky.glsl"
#include "bed/water_body.glsl"
#include "bed/water.glsl"

uniform float tinted;  // 0: the colours mean something of the water, so it is not seen itself

const float grain_hidden = 0.85;  // of the sand's, under a closed film

in vec2 place;
out vec4 colour;  // alpha: how much of the grain is seen

// Wet sand: water between the grains leads light deeper in, so less of it comes back.
vec3 wetted(vec3 albedo, float damp) { return mix(albedo, albedo * (0.30 + 0.42 * albedo), damp); }

// White water where it shoots, most where it is rougher than usual or its surface is steep: at fronts and jumps. A film
// is too thin to hold air.
float foam_cover(vec2 place, vec2 world, Water water) {
    float shooting = smoothstep(0.9, 1.3, water.froude);
    if (shooting == 0.0) return 0.0;
    float rougher = smoothstep(1.05, 1.6, water.froude / max(usual_froude, 0.9));
    float front = smoothstep(0.06, 0.30, length(texture(water_slope_map, place).xy));
    float stirred = max(0.6 * rougher, front);
    float deep = smoothstep(0.05, 0.25, water.depth / clarity);
    float pattern = 0.5 + 0.5 * streaks(world, water.flow, 1.1);
    return shooting * deep * smoothstep(0.44, mix(1.20, 0.90, stirred), pattern) * mix(0.06, 0.85, stirred);
}

void main() {
    BedPoint point = bed_point(place);
    vec2 world = (place - 0.5) * extent;
    vec3 world_point = vec3(world, 0.0);
    vec3 to_eye = direction_to_eye(world_point);
    vec3 albedo = ground_albedo(place, point);
    Water water = water_at(place);
    float seen = tinted;
    float damp = seen * water.damp;

    vec3 light = ground_light(wetted(albedo, damp), point, to_eye, 1.0 + 2.0 * damp);
    if (seen * water.film > 0.0) {
        vec3 normal = water_normal(place, world, point, water);
        float n_dot_v = max(dot(normal, to_eye), 0.10);
        float n_dot_l = max(dot(normal, to_sun), 0.0);
        // Down with the sun, up to the eye, both bent towards the vertical by refraction.
        float up = sqrt(1.0 - (1.0 - n_dot_v * n_dot_v) / 1.77);
        vec3 left = transmitted(0.5 * water.depth / clarity * (1.0 + 1.0 / up));
        vec3 body = water_body_colour() * (sun_light * point.sun * (0.4 + 0.6 * n_dot_l) + sky_light);
        vec3 below = light * left + body * (1.0 - left);

        float grazing = (1.0 - n_dot_v) * (1.0 - n_dot_v);
        float fresnel = 0.02 + 0.98 * grazing * grazing * (1.0 - n_dot_v);  // Schlick 1994
        vec3 mirrored = reflect(-to_eye, normal);
        mirrored.z = abs(mirrored.z);
        vec3 reflected = sky(normalize(mirrored)) * mix(0.5, 1.0, point.sky);
        vec3 halfway = normalize(to_sun + to_eye);
        float off = 1.0 - max(dot(normal, halfway), 0.0);
        float lobe = 1.0 / (1.0 + 120.0 * off);
        float glint = lobe * lobe * lobe;
        vec3 surface = mix(below, reflected, min(1.3 * fresnel, 1.0)) + sun_light * (point.sun * glint);

        float foam = foam_cover(place, world, water);
        vec3 foam_light = vec3(0.86, 0.88, 0.88) * (sun_light * point.sun * (0.25 + 0.75 * n_dot_l) + sky_light * point.sky);
        surface = mix(surface, foam_light, foam);
        light = mix(light, surface, water.film);
    }
    colour = vec4(display_from_linear(tone_curve(with_haze(light, world_point, -to_eye))),
                  1.0 - seen * water.film * grain_hidden);
}
