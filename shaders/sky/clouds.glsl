// How clouds look, on shells above the curved Earth, fixed in the world. Lengths in km. Needs common/light.glsl before it.
#include "sky/cloud_shapes.glsl"

uniform vec3 cloud_sun;    // the sun's irradiance at their height
uniform float pixel;       // its angle, radians
uniform float cloud_haze;  // extinction of the air at the ground, per km
uniform float cloud_haze_height;  // km, over which the haze thins by e

struct CloudLight {
    vec3 light;      // that they send to the eye
    float through;   // share of what is behind them that is seen
};

const float farthest_cloud = 90.0;
const float lowest_cloud = -0.02;  // of directions: those of a high place see clouds below the horizon

// Henyey and Greenstein's phase function, times 4π.
float hg(float cosine, float g) {
    float base = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (base * sqrt(base));
}

// Extinction per km on the way to a height, the air thinning upward.
float haze_up_to(float height) {
    float scale = cloud_haze_height;
    return cloud_haze * scale / height * (1.0 - exp(-height / scale));
}

// How much of what far clouds send is left, and nothing of those at the end of sight.
float air_transmittance(float haze, float distance_to) {
    return exp(-haze * distance_to) * (1.0 - smoothstep(0.6 * farthest_cloud, farthest_cloud, distance_to));
}

// What lights a cumulus cloud from below: ground that others shade in part.
vec3 ground_below() {
    float lit = 1.0 - 0.8 * clamp(0.5 - 1.2 * cloud_threshold, 0.0, 1.0);
    return vec3(0.42, 0.30, 0.18) * in_air * (sun_light * (max(to_sun.z, 0.0) * lit) + sky_light);
}

// Sunlight that a droplet or many of them throw to the eye, behind optical depths towards the sun, see depths_to_sun(): once
// scattered ahead, which makes the silver edge; and many times, to all sides, of which what comes far falls as two streams in a
// layer do. `ahead` and `aside` are those of the ray.
float scattered_sun(float ahead, float aside, vec2 depths) {
    float depth = depths.x + depths.y;
    float many = 0.52 * exp(-0.36 * depth) + (0.34 + 0.30 * to_sun.z) / (1.0 + 0.10 * depth);
    return ahead * exp(-0.3 * depths.x - 0.15 * depths.y) + many * aside;
}

// How much of a cloud stands above a place in it.
float cumulus_above(float inside, float height) {
    float up = max(height, 0.0) / cumulus_thickness;
    float strength = max(inside + 1.15 * up * sqrt(up), 0.0) * (1.0 / 1.15);
    float top = sqrt(strength) * min(0.55 + 0.45 * strength, 1.0);  // nearly its power of 2/3
    return cumulus_thickness * max(top - up, 0.0);
}

// Ratio of the cloud above a point to the thickness of its outline, from above: bases are mottled.
float cumulus_thinner(vec3 at) {
    vec2 p = at.xy - cloud_shift + 0.4 * at.z;
    float mottles = 0.55 * cloud_noise(turned_b * p * (1.0 / 0.33) + 1.9) + 0.45 * cloud_noise(turned_a * p * (1.0 / 0.13) + 8.3) +
                    0.30 * cloud_noise(turned_b * p * (1.0 / 0.055) + 4.1);
    return max(1.0 + 1.1 * clamp(1.2 - 2.5 * at.z, 0.3, 1.0) * mottles, 0.1);
}

// Optical depths towards the sun at a place of a cloud: of what is near, and of what its outline says is above.
vec2 depths_to_sun(vec3 at, float inside, float finest) {
    float depth = 0.0;
    for (int i = 0; i < 2; ++i) {
        float away = i == 0 ? 0.045 : 0.20;
        vec3 lit = at + to_sun * away;
        float there = cumulus_outline(lit.xy, lit.z);
        there += cumulus_bulges(lit, there, finest + 0.25 * away, i == 0 ? 3 : 2);
        depth += clamp((there + 0.03) * (1.0 / 0.21), 0.0, 1.0) * (i == 0 ? 0.11 : 0.22);
    }
    float above = cumulus_above(inside, at.z);
    return cumulus_extinction * vec2(depth, 0.6 * above * cumulus_thinner(at));
}

// Along the ray by steps: long ones where no cloud can be, and the first in a cloud from its very surface on.
CloudLight cumulus_light(vec3 from, vec3 view, vec3 behind) {
    CloudLight cloud = CloudLight(vec3(0.0), 1.0);
    float t = along_to(view.z, cloud_base - from.z);
    float end = min(along_to(view.z, cloud_base + cumulus_thickness - from.z), farthest_cloud);
    float towards_sun = dot(view, to_sun);
    float ahead = min(0.14 * hg(towards_sun, 0.86) + 0.06 * hg(towards_sun, 0.45), 8.0);
    float aside = 0.88 - 0.12 * towards_sun;
    float haze_on_way = haze_up_to(max(cloud_base + 0.3 - from.z, 0.1));
    vec3 from_below = 0.5 * ground_below();
    float before = 1.0;
    float step = 0.0;
    vec2 depths = vec2(1.0);  // towards the sun
    for (int i = 0; i < 80 && t < end && cloud.through > 0.06; ++i) {
        vec3 at = from + view * t;
        vec3 position = vec3(at.xy, at.z + curve * t * t * dot(view.xy, view.xy) - cloud_base);
        float outline = cumulus_outline(position.xy, position.z);
        float room = outline + cumulus_most_bulge(position.z);
        float ahead_by = max(0.03 + 0.006 * t, -0.5 * room);
        // A loop of one round or none, since llvmpipe works out both sides of a condition.
        for (int near = 0; near < (room < 0.0 ? 0 : 1); ++near) {
            float finest = 2.0 * pixel * t;
            float inside = outline + cumulus_bulges(position, outline, finest, 4);
            ahead_by = inside < 0.0 ? clamp(-0.35 * inside, 0.012 + 0.0025 * t, 0.1) : 0.034 + 0.004 * t;
            float opaque = 1.0 - exp(-cumulus_density(inside, position.z) * cumulus_extinction * ahead_by);
            if (inside > 0.02 && before < 0.0) {
                ahead_by = -step * (inside - 0.01) / (inside - before);
                inside = 1.0;
                opaque = 0.0;
            }
            room = inside;
            for (int lit = 0; lit < (opaque > 0.002 ? 1 : 0); ++lit) {
                for (int j = 0; j < (cloud.through * opaque > 0.012 ? 1 : 0); ++j) depths = depths_to_sun(position, 0.5 * (outline + inside), finest);
                float up = clamp(position.z / 0.7, 0.0, 1.0);
                float open = exp(-2.6 * max(inside, 0.0));
                // Heads get more light than the creases between them.
                float head = clamp(1.0 + 0.8 * (inside - outline) / cumulus_bulge(position.z), 0.6, 1.2);
                vec3 light = cloud_sun * scattered_sun(ahead, aside, depths);
                light += mix(0.40, 0.80, up) * (0.45 + 0.55 * open) * (in_air * sky_light) + ((1.0 - up) * (0.6 + 0.4 * open)) * from_below;
                light *= head;
                cloud.light += cloud.through * opaque * mix(behind, light, air_transmittance(haze_on_way, t));
                cloud.through *= 1.0 - opaque;
            }
        }
        before = room;
        step = ahead_by;
        t += ahead_by;
    }
    cloud.through = max(cloud.through - 0.06, 0.0) / 0.94;
    return cloud;
}

CloudLight cirrus_light(vec3 from, vec3 view, vec3 behind) {
    float t = along_to(view.z, cloud_base - from.z);
    vec3 at = from + view * t;
    float slant = view.z + 2.0 * curve * t;  // the sine at which the shell is met
    float depth = cirrus_depth(at.xy, 1.5 * pixel * t / max(slant, 0.02)) / max(slant, 0.22);
    float opaque = 1.0 - exp(-depth);
    float towards_sun = dot(view, to_sun);
    vec3 light = cloud_sun * (0.52 + 0.050 * min(hg(towards_sun, 0.80), 20.0)) + 0.70 * (in_air * sky_light);
    float haze = air_transmittance(haze_up_to(max(cloud_base - from.z, 0.1)), t);
    return CloudLight(opaque * mix(behind, light, haze), 1.0 - opaque);
}

// In a direction of view (unit vector) from a place in km, of which z counts from the ground; `behind`: the sky's light.
CloudLight march_clouds(vec3 from, vec3 view, vec3 behind) {
    return clouds < 1.5 ? cumulus_light(from, view, behind) : cirrus_light(from, view, behind);
}
