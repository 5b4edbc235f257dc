// Prints of feet in sand, as relief by which the light on it is found: normals, the shadow of its own walls, and how
// much of the sky is seen from within. Lengths in metres, heights against the ground as it was. Needs common/noise.glsl,
// common/light.glsl and bed/bed.glsl before it.
flat in vec3 print_root;    // block lengths, as the samples' places count
flat in vec4 print_form;    // heading, 1 for the right foot or -1, depth
flat in vec4 print_ground;  // slope of the ground, how far the print has slid, and unevenness
uniform float metre;        // block lengths
uniform float angle;        // between two samples
uniform float step_length;  // of the walker
uniform float half_step_width;

const float rim_height = 0.014;  // highest
const float marked_share = 0.24; // of a strip 0.4 m wide along the track, what prints cover

// Below 0 within a shape as wide as two circles and what lies between them.
float outside(vec2 p, vec2 from, float from_radius, vec2 to, float to_radius) {
    vec2 way = to - from;
    float share = clamp(dot(p - from, way) / dot(way, way), 0.0, 1.0);
    return length(p - from - share * way) - mix(from_radius, to_radius, share);
}

float bump(float x) { return exp(-x * x); }

// A print on ground that holds it: height, and how far a place is marked.
vec2 standing_print(vec2 at) {
    vec2 heading = print_form.xy;
    vec2 p = vec2(print_form.z * (at.x * heading.y - at.y * heading.x), dot(at, heading));  // outward and forward
    float own = 97.0 * print_ground.w;
    float noise = value_noise(21.0 * p + own);
    float crumbs = value_noise(75.0 * p + own);
    float off = min(outside(p, vec2(0.0, -0.095), 0.036, vec2(0.004, 0.05), 0.048), outside(p, vec2(0.004, 0.05), 0.048, vec2(-0.010, 0.105), 0.033));
    off += 0.007 * noise + 0.0015 * crumbs;
    // Heel and ball sink in deeper than the arch; loose sand stands at its angle of repose around them.
    float depth = print_form.w * (0.78 + 0.22 * bump((p.y + 0.09) / 0.05) + 0.30 * bump((p.y - 0.06) / 0.05));
    float rim = 0.007 * (1.0 + 0.6 * noise + 0.2 * crumbs) * (0.7 + 0.5 * smoothstep(0.0, 0.14, abs(p.y)));
    float height = rim * bump((off - 0.034) / 0.024) - depth * (1.0 - smoothstep(-0.038, 0.024, off));
    return vec2(height, 1.0 - smoothstep(0.045, 0.095, off));
}

// One on a slope that does not: the sand above has come down after the foot, and lies in a tongue below.
vec2 slid_print(vec2 at) {
    vec2 down = -normalize(print_ground.xy + vec2(1e-5, 0.0));
    float own = 61.0 * print_ground.w;
    vec2 p = vec2(dot(at, vec2(-down.y, down.x)), dot(at, down));
    float noise = value_noise(13.0 * p + own);
    float fine = value_noise(40.0 * p + own);
    float reach = 0.30 + 0.28 * print_ground.w;
    p += vec2(0.02 * noise + 0.3 * (fract(own) - 0.5) * p.y, 0.02 * noise);
    float along = p.y / reach;
    float width = mix(0.085, 0.16, smoothstep(-0.3, 0.8, along)) * (1.0 + 0.12 * fine);
    float within = 1.0 - smoothstep(0.35, 1.05, abs(p.x) / width);
    float scar = smoothstep(-0.17, -0.08, p.y) * (1.0 - smoothstep(0.0, 0.85, along));
    // Where all around is as steep as sand can lie its front is thin.
    float lobe = smoothstep(0.25, 0.8, along) * (1.0 - smoothstep(0.75, 1.45, along + 0.06 * fine));
    float height = within * (0.013 * lobe - 1.25 * print_form.w * scar) + 0.005 * scar * bump((abs(p.x) / width - 1.0) / 0.25);
    float marked = (1.0 - smoothstep(1.0, 1.5, abs(p.x) / width)) * smoothstep(-0.26, -0.19, p.y) * (1.0 - smoothstep(1.2, 1.5, along));
    return vec2(height, marked);
}

vec2 print_at(vec2 at) {
    vec2 standing = standing_print(at);
    vec2 slid = slid_print(at);
    return vec2(mix(standing.x, slid.x, print_ground.z), max(standing.y, smoothstep(0.1, 0.6, print_ground.z) * slid.y));
}

// What a sample sees of a print.
struct Trodden {
    float share;   // of it
    vec3 normal;   // mean
    float direct;  // of the sun's light that gets to the ground
    float sun;     // how much of that the print's walls let through
    float sky;
};

// Where the line from the eye to a place on the untrodden ground meets the print.
vec2 met(vec2 at, vec2 shift) {
    const int steps = 8;
    float deepest = -1.3 * print_form.w;
    float above = rim_height;
    float gap_above = rim_height;
    for (int i = 1; i <= steps; ++i) {
        float height = mix(rim_height, deepest, float(i) / float(steps));
        float gap = height - print_at(at + height * shift).x;
        if (gap <= 0.0) return at + shift * mix(above, height, gap_above / max(gap_above - gap, 1e-5));
        above = height;
        gap_above = gap;
    }
    return at + shift * deepest;
}

// How much of the sun's disc a place in a print sees.
float sunlit(vec2 at, float height, vec2 shift) {
    const int steps = 8;
    float open = 1.0;
    for (int i = 1; i <= steps; ++i) {
        float above = (rim_height - height) * float(i * i) / float(steps * steps);
        float over = print_at(at + above * shift).x - height - above;
        open = min(open, 1.0 - smoothstep(0.0, 0.006, over));
    }
    return open;
}

// `at` is counted from the print's middle, `uneven` are slopes of the sand itself, `across` and `up` what the sample spans.
Trodden trodden(vec2 at, vec3 ground, vec2 uneven, vec3 to_eye, float across, vec2 up) {
    vec2 slope = -ground.xy / max(ground.z, 0.1);
    float eye_rise = to_eye.z - dot(slope, to_eye.xy);
    float sun_rise = to_sun.z - dot(slope, to_sun.xy);
    vec2 to_sun_shift = to_sun.xy / max(sun_rise, 0.03);
    float sunward = smoothstep(0.0, 0.06, sun_rise);  // ground that turns from the sun shades what lies in it
    int parts = clamp(int(ceil(length(up) / 0.035)), 1, 12);
    float coarsest = max(across, length(up) / float(parts));
    float resolved = 1.0 - smoothstep(0.04, 0.12, coarsest);
    vec2 to_eye_shift = resolved * to_eye.xy / max(eye_rise, 0.12);
    float apart = clamp(0.4 * coarsest, 0.003, 0.02);

    Trodden sum = Trodden(0.0, vec3(0.0), 0.0, 0.0, 0.0);
    if (length(at) > mix(0.34, 0.95, print_ground.z) + length(up)) parts = 0;
    for (int i = 0; i < parts; ++i) {
        vec2 foot = met(at + ((float(i) + 0.5) / float(parts) - 0.5) * up, to_eye_shift);
        vec2 here = print_at(foot);
        vec2 rise = vec2(print_at(foot + vec2(apart, 0.0)).x, print_at(foot + vec2(0.0, apart)).x) - here.x;
        vec3 normal = normalize(vec3(-slope - uneven - rise / apart, 1.0));
        float open = sunward * sunlit(foot, here.x, to_sun_shift);
        float weight = here.y * resolved / float(parts);
        sum.share += weight;
        sum.normal += weight * normal;
        sum.sun += weight * open;
        sum.direct += weight * open * max(dot(normal, to_sun), 0.0);
        sum.sky += weight * (1.0 - 0.2 * clamp(-here.x / 0.03, 0.0, 1.0));
    }

    // Too fine to be seen: of its walls those that face the eye are seen the most.
    vec2 rightward = vec2(print_form.y, -print_form.x);
    float spread = abs(dot(up, rightward)) + across * abs(dot(normalize(vec2(-to_eye.y, to_eye.x) + 1e-5), rightward)) + 1e-4;
    float aside = dot(at, rightward) + print_form.z * half_step_width;
    float strip = clamp(min(aside + 0.5 * spread, 0.2) - max(aside - 0.5 * spread, -0.2), 0.0, 1.0) / spread;
    float own = step(abs(dot(at, print_form.xy)), 0.5 * step_length);
    float weight = (1.0 - resolved) * marked_share * strip * own;
    vec3 level = normalize(vec3(-slope - uneven, 1.0));
    float facing = max(dot(level, to_sun), 0.0);
    sum.share += weight;
    sum.normal += weight * level;
    sum.sun += weight;
    sum.direct += weight * clamp(facing + 0.09 * dot(to_sun.xy, to_eye.xy) / max(eye_rise, 0.1), 0.5 * facing, 1.5 * facing);
    sum.sky += weight * 0.93;

    float whole = 1.0 / max(sum.share, 1e-4);
    return Trodden(sum.share, normalize(sum.normal + vec3(0.0, 0.0, 1e-5)), whole * sum.direct, whole * sum.sun, whole * sum.sky);
}

// As far as light from the sky goes: the brighter sky that a wall faces is half hidden by the wall before it.
vec3 sky_normal(Trodden print, BedPoint open_ground) { return normalize(print.normal + open_ground.normal); }

// By how much the light from a print differs from that of open ground with the same normal: of the sky that its walls
// hide, they throw back what they get themselves.
vec3 between_walls(Trodden print, vec3 albedo, BedPoint open_ground) {
    vec3 sky = sky_light * open_ground.sky;
    vec3 walls = albedo * (0.8 * sky + 0.5 * sun_light * (open_ground.sun * max(dot(open_ground.normal, to_sun), 0.0)));
    return albedo * (1.0 - print.sky) * (walls - sky);
}
