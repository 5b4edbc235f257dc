#version 330 core
// Sand so near that its wind ripples are seen, and the tongues of its avalanches.
#include "colour.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "oren_nayar.glsl"
#include "bed.glsl"
#include "ground.glsl"
#include "rock.glsl"
#include "world.glsl"

uniform vec2 wind;           // where it blows to, unit vector
uniform float ripple_phase;  // of the eye's place, in turns
uniform float ripple_slope;  // steepest
uniform sampler2D wind_map;  // how far ground upwind leaves the wind to the bed

const float tau = 6.2831853;

// Turns of a train of ripples from one place to another. Sand that rolls downslope turns crests: they run on around a
// dune as if each began that much later.
float turns(vec3 way) { return (dot(way.xy, wind) - 0.8 * way.z) / ripple_length; }

// Cosine and sine of the ripples' phase at a place, and how high they stand. A second train of waves, whose
// strength and phase wander, cancels the first in places: there crests end or fork.
vec3 ripples(vec3 offset, vec2 wander) {
    float phase = turns(offset) + ripple_phase +
                  1.5 * value_noise(wander * 0.31 + 5.3) + 0.35 * value_noise(wander * 1.3 + 2.9);
    float turn = tau * fract(phase);
    vec2 second = vec2(0.6 + 1.5 * value_noise(wander), 1.5 * value_noise(wander + 17.3));
    float strength = length(second);
    second /= max(strength, 1e-3);
    float c = cos(turn);
    float s = sin(turn);
    return vec3(c * second.x - s * second.y, s * second.x + c * second.y, min(3.0 * strength, 1.0));
}

void main() {
    SeenPlace at = seen_place();
    vec3 offset = at.offset;
    vec2 place = bed_place(at);
    vec2 place_along = at.along.xy / extent;
    vec2 place_up = at.up.xy / extent;
    BedPoint point = bed_point(textureGrad(lighting_map, place, place_along, place_up));
    vec3 to_eye = -normalize(offset);
    vec2 slope = -point.normal.xy / max(point.normal.z, 0.1);
    float steep = length(slope);
    vec2 lee = vec2(-wind.y, wind.x);  // along the crests

    vec2 whole = (whole_eye + offset.xy) / ripple_length;
    vec2 wander = vec2(dot(whole, wind), 0.45 * dot(whole, lee)) / 7.0;
    float footprint = abs(turns(at.along)) + abs(turns(at.up));
    vec3 wave = ripples(offset, wander);
    float open = textureGrad(wind_map, place, place_along, place_up).r;
    vec4 sand = sand_colour(at);
    float standing = sand.a * wave.z * (0.75 + 0.35 * value_noise(wander * 0.21 + 9.1)) * smoothstep(0.15, 0.6, open) * (1.0 - smoothstep(0.488, 0.601, steep));
    float resolved = standing * (1.0 - smoothstep(0.15, 0.45, footprint));
    vec2 turned = wind - 0.8 * slope;
    turned /= max(length(turned), 0.2);
    vec2 tilt = turned * (ripple_slope * resolved * (wave.x - 0.2 * (2.0 * wave.x * wave.x - 1.0)));

    // Tongues of sand that slid down steep faces.
    float slid = smoothstep(0.46, 0.58, steep);
    float length_down = (offset.z + eye.z) / ripple_length;
    vec2 down = vec2(dot(whole, lee) / 6.0, length_down / 22.0);
    float tongue = value_noise(down) + 0.5 * value_noise(2.3 * down + 7.7);
    slid *= 1.0 - smoothstep(0.3, 0.8, footprint / 6.0);
    tilt += lee * (0.045 * slid * tongue);

    point.normal = normalize(vec3(-slope - tilt, 1.0));
    vec3 albedo = albedo_of(sand, 0.10 * sand_grain * grain(at) + 0.03 * slid * tongue);
    if (marks > 1.5) weather(point.normal, albedo, in_metres(offset), metres(length(at.along) + length(at.up)), rock_share(place));
    // Troughs see less of the sky.
    point.sky *= 1.0 + 0.4 * ripple_slope * resolved * (wave.y - 1.0);
    colour = seen(ground_light(albedo, point, to_eye, 1.0), at, to_eye);
}
