// Ground that water shapes and water over it, at one place: wet ground is darker and glossier, what the water laid down is
// paler, and the water tints it by its depth, mirrors the sky and the banks and foams where it shoots (Froude number over 1).
// Needs common/colour.glsl, common/light.glsl, common/oren_nayar.glsl, bed/bed.glsl, bed/ground.glsl, sky/sky.glsl,
// bed/water_body.glsl, bed/drape.glsl, bed/soil.glsl and bed/water.glsl before it, and `under_water`: dry_water where it is known that no
// water is closed, thin_water where it is a film at most (see bed/water.glsl), else any_water.
uniform float tinted;  // 0: the colours mean something of the water, so it is not seen itself

const float grain_hidden = 0.85;  // of the sand's, under a closed film

// Wet sand: water between the grains leads light deeper in, so less of it comes back.
vec3 wetted(vec3 albedo, float damp) { return mix(albedo, albedo * (0.34 + 0.15 * albedo + 0.22 * luminance(albedo)), damp); }

// Fresh silt and sand are pale; where the bed was worn, damp soil from below lies open.
vec3 worked(vec3 albedo, float laid) {
    vec3 fresh = mix(albedo, vec3(0.66, 0.56, 0.43), 0.45);
    vec3 worn = albedo * vec3(0.72, 0.68, 0.64);
    return mix(mix(albedo, fresh, max(laid, 0.0)), worn, max(-laid, 0.0));
}

// Soil is less golden than a dune's sand.
vec3 earthen(vec3 albedo) { return covered < 0.5 ? mix(vec3(luminance(albedo)), albedo, 0.54) : albedo; }

// Where it lies dry, rain has beaten a pale crust, in patches; a wall shows the moister soil below in its layers.
vec3 earthen(vec3 albedo, Soil soil, float damp) {
    albedo = earthen(albedo);
    float crust = (1.0 - grown) * (1.0 - damp) * (1.0 - soil.cut) * smoothstep(-0.5, 0.9, soil.height);
    albedo = mix(albedo, vec3(0.66, 0.565, 0.43), 0.40 * crust);
    vec3 below = albedo * mix(vec3(0.68, 0.57, 0.47), vec3(1.06, 0.97, 0.84), clamp(0.5 + 0.5 * soil.layers, 0.0, 1.0));
    return mix(albedo, below, soil.cut);
}

// Of the sky, or of the banks that hide its lower part.
vec3 mirrored_light(vec3 mirrored, vec3 albedo, BedPoint point) {
    float bank = 1.0 - point.sky;  // about the sine of their height
    float hidden = 1.0 - smoothstep(0.5 * bank, 1.5 * bank + 0.02, mirrored.z);
    vec3 banks = albedo * (0.30 * sun_light * max(to_sun.z, 0.0) + 0.45 * sky_light);
    return mix(studio > 0.5 ? studio_around(normalize(mirrored)) : sky(normalize(mirrored)), banks, hidden * smoothstep(0.02, 0.10, bank));
}

struct WetGround {
    vec3 light;
    float film;    // of water, 0 … 1
    float grainy;  // how much of the grain is seen
    Laid cover;
};

// The light that leaves a place (0 … 1 in the maps) which lies at `world_point`. `water`: of it; `shown`: of the ground there, and
// water's cover of it in alpha; `width`: of the smallest thing to be seen there, block lengths.
WetGround wet_ground(vec2 position, BedPoint point, vec3 albedo, Water water, vec4 shown, vec3 world_point, vec3 to_eye, float width) {
    vec2 world = world_point.xy;
    float visible = tinted;
    float laid = 2.0 * shown.g - 1.0;
    Soil soil = soil_at(world_point, point, width, clamp(-laid, 0.0, 1.0), grown);
    if (under_water > dry_water) {
        float cover = by_cover(width);
        water.film = mix(closed_film(water, soil), shown.a, cover);
        water.depth = mix(water.depth, depth_by_cover(water.depth, shown.a), cover);
    }
    float damp = mix(1.0, 0.85, studio) * visible * clamp(shown.r + 0.8 * shown.r * (1.0 - shown.r) * -soil.height, 0.0, 1.0);
    vec3 mean_albedo = albedo;  // of the ground around
    if (natural > 0.5) {
        mean_albedo = earthen(albedo);
        albedo = earthen(albedo, soil, damp);
        albedo = worked(albedo, visible * laid);
        albedo *= (1.0 + 0.13 * soil.tone) * (1.0 - 0.45 * soil.groove);
        albedo = mix(albedo, mix(vec3(0.25, 0.20, 0.155), vec3(0.46, 0.39, 0.31), clamp(0.5 + soil.tone, 0.0, 1.0)), soil.stone);
    }
    Laid cover = drape_at(position, width / extent);
    albedo = with_drape(albedo, cover);
    mean_albedo = with_drape(mean_albedo, cover);
    if (draped > 0.5) {  // what nobody has surveyed gives way
        soil.slope *= 1.0 - cover.share;
        soil.groove *= 1.0 - cover.share;
    }
    // Under water the sun stands higher, bent by the surface, so that small slopes throw less shade.
    float bent = mix(1.0, to_sun.z / sqrt(0.77 + to_sun.z * to_sun.z), visible * water.film * (1.0 - water.thin));
    vec3 normal_below = normalize(vec3(point.normal.xy / max(point.normal.z, 0.05) - bent * soil.slope, 1.0));
    // Ground behind the sun stands in the shade of its own clods, but for the highest; the water over it does not.
    BedPoint on_water = point;
    point.sun *= smoothstep(-0.22, 0.14, dot(point.normal, to_sun));
    // Flanks of rills face each other: of their hemisphere all but the cosine of their slope is the one across, so that rilled
    // ground gets as much of the sky as a plane does.
    if (atmosphere > 0.5) point.sky *= max(dot(point.normal, normal_below), 0.3);
    point.normal = normal_below;
    point.sky *= clamp(1.0 + 0.10 * soil.height, 0.6, 1.1) * (1.0 - 0.25 * soil.groove);

    eroded = true;
    // A wall's soil is drawn moist as it is.
    vec3 wet = wetted(albedo, damp * (1.0 - 0.6 * soil.cut));
    vec3 light;
    if (atmosphere > 0.5) {
        // Crumbs stand in the sun on ground that turns away from it. What faces a dark groove is as light as the ground is on the whole.
        float direct = roughened(point.sun * mean_facing(dot(point.normal, to_sun), 0.25), point.normal, to_eye, 0.25);
        light = ground_light_of(wet, wetted(mean_albedo, visible * shown.r), direct, point, to_eye, 1.0 + 2.0 * damp);
    } else {
        light = ground_light(wet, point, to_eye, 1.0 + 2.0 * damp);
    }
    if (under_water > dry_water) {
        vec3 around = light_onto(vec3(0.0), albedo, on_water);
        float sun = on_water.sun;
        Rings rings = drop_rings(world, water, width);
        vec3 normal = water_normal(world, water, soil, rings.slope, width);
        float thin = water.thin;
        float rough = sqrt(rings.rough);
        float n_dot_v = max(dot(normal, to_eye), 0.10 + 0.14 * max(thin, smoothstep(0.9, 1.6, water.froude)) + 0.5 * rough);
        float n_dot_l = max(dot(normal, to_sun), 0.0);
        // Down with the sun, up to the eye, both bent towards the vertical by refraction.
        float up = sqrt(1.0 - (1.0 - n_dot_v * n_dot_v) / 1.77);
        vec3 left = transmitted(0.5 * water.depth / clarity * (1.0 + 1.0 / up), water.turbidity);
        float silt = under_water > thin_water ? silt_clouds(world, water) : 0.0;
        vec3 body = water_body_colour(water.turbidity) * (1.0 + water.turbidity * silt * vec3(0.26, 0.22, 0.18)) * (sun_light * sun * (0.4 + 0.6 * n_dot_l) + around);
        vec3 below = light * left + body * (1.0 - left);

        float grazing = (1.0 - n_dot_v) * (1.0 - n_dot_v);
        float fresnel = 0.02 + 0.98 * grazing * grazing * (1.0 - n_dot_v);  // Schlick 1994
        // What stands out of it, or breaks it where it runs down a slope, does not mirror.
        float calm = smoothstep(0.7, 1.4, water.depth / closed_depth) * (1.0 - smoothstep(0.03, 0.15, water.fall));
        float mirrors = 0.3 + 0.7 * max(calm, 1.0 - thin);
        fresnel *= mirrors;
        vec3 halfway = normalize(to_sun + to_eye);
        float off = 1.0 - max(dot(normal, halfway), 0.0);
        float spread = 1.0 + 60.0 * rings.rough;
        float lobe = 1.0 / (1.0 + 220.0 / spread * off);
        float glint = mirrors * mirrors * lobe * lobe * lobe / spread;
        vec3 mirrored = reflect(-to_eye, normal);
        mirrored.z = max(abs(mirrored.z), 0.5 * to_eye.z);  // waves hide what of them turns away from the eye
        vec3 reflected = mirrored_light(mirrored, albedo, point);
        reflected = mix(reflected, point.sky * haze_towards(-to_eye), max(0.5 * thin, min(3.0 * rough, 0.7)));  // from a wide part of the sky
        vec3 surface = mix(below, reflected, fresnel) +
                       sun_light * (sun * glint);

        float foam = under_water > thin_water ? max(foam_cover(world, water, width), foam_lines(world, water, silt, width)) : 0.0;
        vec3 foam_light = mix(vec3(0.86, 0.88, 0.88), vec3(0.76, 0.68, 0.56), water.turbidity) * (sun_light * sun * (0.25 + 0.75 * n_dot_l) + around);
        surface = mix(surface, foam_light, foam);
        light = mix(light, surface, water.film);
    }
    float grainy = 1.0 - visible * water.film * grain_hidden;
    if (draped > 0.5) grainy *= 1.0 - cover.share;
    return WetGround(light, visible * water.film, grainy, cover);
}

// The display colour of a place of a block, and in alpha how much of the grain is seen. `level`: of the maps' mipmaps.
vec4 water_ground(vec2 position, vec3 world_point, float width, float level) {
    BedPoint point = bed_point(textureLod(lighting_map, position, level));
    vec3 to_eye = direction_to_eye(world_point);
    vec4 shown = vec4(ground_at(position, level), cover_at(position, level));
    vec3 albedo = natural > 0.5 ? ground_albedo(position, point, shown.b) : ground_albedo(position, point);
    WetGround ground = wet_ground(position, point, albedo, water_at(position, level), shown, world_point, to_eye, width);
    vec3 displayed = display_from_linear(tone_curve(with_haze(ground.light, world_point, -to_eye)));
    return vec4(as_it_is(displayed, ground.cover, 1.0 - ground.film), ground.grainy);
}
