// Bare ground below the grid, where water shapes it: crumbs and clods, rills down steep slopes, layers in cut walls, stones
// that the water leaves behind. It is looks: nothing of it is computed by the model, it moves no water and no light of its
// own casts shadow, and it stands where the bed is, whatever the time. Needs common/light.glsl, bed/bed.glsl before it.
uniform float strata;          // 1: layers in cut walls, and stones
uniform sampler2D streak_map;  // seamless: noise, and its slopes east and north around ½
uniform sampler2D rill_map;    // the same for rills, a mix of two wavelengths
uniform float cell;            // of the bed's grid, block lengths
uniform float texel;           // of what is shaded, block lengths
uniform float pixel_width;     // of a pixel, block lengths: at distance 1, or anywhere without perspective

const float noise_repeat = 256.0;  // of features of streak_map to its side

struct Soil {
    vec2 slope;    // that it adds to the ground's
    float height;  // about −1 … 1: hollows and clods
    float tone;    // of its colour, about −1 … 1
    float stone;   // 0 … 1: share that a stone covers
    float cut;     // 0 … 1: a wall, where what lies below the crust is open
    float layers;  // about −1 … 1: of the soil in it
    float groove;  // 0 … 1: of light that a groove between ribs takes
};

// Lengths of the smallest thing to be seen at a point.
float pixel_width_at(vec3 point) { return max(texel, pixel_width * mix(distance(eye, point), 1.0, parallel)); }

float detail_visibility(float wavelength, float width) { return 1.0 - smoothstep(0.22, 0.60, width / wavelength); }

// Noise of a wavelength and its slopes, about −1 … 1, as far as a width lets it be seen.
vec3 shown_noise(vec2 at, float wavelength, float width) {
    return detail_visibility(wavelength, width) * (2.0 * texture(streak_map, at / (noise_repeat * wavelength)).rgb - 1.0);
}

// 0 … 1: `worn`, how far water has carried the fines away; `grown`, how far grass holds the soil together, so that rain does not cut it.
Soil soil_at(vec3 world_point, BedPoint point, float width, float worn, float grown) {
    vec2 world = world_point.xy;
    vec3 clods = shown_noise(world + 0.37, 3.1 * cell, width);
    vec3 lumps = shown_noise(world.yx + 0.11, 1.13 * cell, width).xzy;
    vec3 crumbs = shown_noise(world + 0.71, 0.41 * cell, width);
    vec3 grit = shown_noise(world.yx + 0.53, 0.15 * cell, width).xzy;
    vec2 down = -point.normal.xy / max(point.normal.z, 0.2);
    float steep = length(down);
    float rough = 0.46 + 0.99 * smoothstep(0.1, 0.7, steep);
    Soil soil;
    soil.slope = rough * (0.30 * clods.yz + 0.42 * lumps.yz + 0.50 * crumbs.yz + 0.45 * grit.yz);
    soil.height = 1.1 * clods.x + 0.9 * lumps.x + 0.7 * crumbs.x;
    soil.tone = 0.8 * clods.x + 0.7 * lumps.x + 0.6 * crumbs.x + 0.8 * grit.x;
    // Centimetres of it, where they are near enough to be seen.
    float pebbles = 0.0;
    float size = 0.055;
    for (int i = 0; i < 2; ++i) {
        vec3 grains = shown_noise(world + 0.29 * float(i + 1), size * cell, width);
        soil.slope += rough * 0.62 * grains.yz;
        soil.tone += 0.9 * grains.x;
        pebbles = i == 0 ? grains.x : pebbles;
        size *= 0.36;
    }
    float rills = mix(1.0, 0.5, studio) * (1.0 - grown) * smoothstep(0.18, 0.55, steep) * detail_visibility(0.9 * cell, width);
    {
        vec2 downslope = down / max(steep, 1e-6);
        vec2 across = vec2(-downslope.y, downslope.x);
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 5; ++i) {
            vec2 at = world + (float(i) - 2.0) * 0.8 * cell * downslope;
            sum += 2.0 * texture(rill_map, at / (noise_repeat * 0.6 * cell)).rgb - 1.0;
        }
        soil.slope += rills * dot(0.90 * sum.yz, across) * across;
        soil.height += rills * 0.45 * sum.x;
    }
    // Water that falls over a wall's edge flutes it: grooves straight down, between ribs.
    soil.groove = 0.0;
    float opened = mix(1.0, 0.35, studio);  // even light fills what is cut into a wall
    float flutes = opened * (1.0 - grown) * smoothstep(0.35, 0.9, steep) * detail_visibility(1.2 * cell, width);
    {
        vec2 downslope = down / max(steep, 1e-6);
        vec2 across = vec2(-downslope.y, downslope.x);
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 3; ++i) {
            vec2 at = world.yx + 0.23 + (float(i) - 1.0) * 1.5 * cell * downslope.yx;
            sum += (2.0 * texture(rill_map, at / (noise_repeat * 0.9 * cell)).rgb - 1.0).xzy;
        }
        soil.slope += flutes * dot(1.9 * sum.yz, across) * across;
        soil.groove = flutes * (1.0 - smoothstep(0.05, 0.32, abs(sum.x + 0.1)));
        soil.height += flutes * 0.5 * sum.x;
    }
    soil.cut = opened * (1.0 - grown) * smoothstep(0.45, 1.0, steep + 0.10 * lumps.x);
    soil.layers = 0.0;
    soil.stone = 0.0;
    if (strata < 0.5) return soil;
    // Laid down level once: they follow the height, a little uneven along it.
    vec2 along = vec2(0.06 * (world.x - 0.7 * world.y), world_point.z + 0.05 * cell * (clods.x + lumps.x));
    vec3 thick = shown_noise(along, 0.75 * cell, width);
    vec3 thin = shown_noise(along, 0.21 * cell, width);
    soil.layers = 1.2 * thick.x + thin.x;
    // Harder ones stand out as ledges.
    soil.slope += soil.cut * (0.7 * thick.z + 0.5 * thin.z) * down / max(steep, 1e-6);
    float lying = mix(0.10, 1.0, worn) * (1.0 - 0.75 * soil.cut);
    soil.stone = smoothstep(0.66 - 0.22 * lying, 0.76 - 0.22 * lying, max(grit.x, pebbles));
    soil.slope += soil.stone * 0.8 * grit.yz;
    return soil;
}
