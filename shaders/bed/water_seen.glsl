// Places that the samples of a pixel see. Needs bed/bed.glsl and bed/soil.glsl before it.
uniform sampler2D seen;       // of block/seen_surface.frag.glsl
uniform vec2 height_span;     // of the surface: the lowest, and how much higher the highest
uniform float samples_along;  // samples along each side of a pixel
uniform vec2 sample_offset;   // of the first pixel's first sample

// Between samples: up to there, in cells of the maps or in widths of a pixel, one place stands for all.
const float near_cells = 1.25;
const float near_widths = 14.0;

struct SeenSamples {
    vec3 mean;    // their place, 0 … 1, as in `seen`
    float cells;  // how far they lie apart, in cells of the maps
    float share;  // of the samples that see the surface
};

vec3 point_at(vec3 place) { return vec3((place.xy - 0.5) * extent, height_span.x + height_span.y * place.z); }

float way_to(vec3 place) { return mix(distance(eye, point_at(place)), -dot(eye_axis, point_at(place)), parallel); }

// For how far apart the samples are, the samples' own sizes included.
float pixels_over_samples() { return samples_along / max(samples_along - 1.0, 1.0); }

float level_over(SeenSamples samples) { return log2(max(0.6 * samples.cells * pixels_over_samples(), 1.0)); }

// Of those at most, or at least, so far away.
SeenSamples samples_between(ivec2 first, float nearest, float farthest) {
    int along = int(samples_along);
    vec3 sum = vec3(0.0);
    vec2 least = vec2(2.0);
    vec2 most = vec2(-1.0);
    float count = 0.0;
    float all = 0.0;
    for (int i = 0; i < along * along; ++i) {
        vec4 there = texelFetch(seen, first + ivec2(i % along, i / along), 0);
        float way = way_to(there.xyz);
        all += there.w;
        if (way < nearest || way >= farthest) there.w = 0.0;
        sum += there.w * there.xyz;
        count += there.w;
        least = min(least, there.xy + 2.0 * (1.0 - there.w));
        most = max(most, there.xy - 2.0 * (1.0 - there.w));
    }
    vec2 apart = max(most - least, vec2(0.0)) * vec2(textureSize(lighting_map, 0));
    return SeenSamples(sum / max(count, 1.0), max(apart.x, apart.y), count / max(all, 1.0));
}

// All of a pixel, or the nearer (`farther` 0) or the farther (1) of them where they are far apart.
SeenSamples seen_samples(float farther) {
    const float anywhere = 1e30;
    int along = int(samples_along);
    ivec2 first = ivec2(gl_FragCoord.xy) * along + ivec2(sample_offset);
    SeenSamples all = samples_between(first, -anywhere, anywhere);
    float cell_length = extent.x / float(textureSize(lighting_map, 0).x);
    float pixel = seen_width(point_at(all.mean));
    int halves = all.cells <= near_cells || all.cells * cell_length <= near_widths * pixel ? 0 : 1;
    // A loop is left, or never entered, where no place needs it; llvmpipe goes through both arms of an if.
    for (int once = 0; once < halves; ++once) {
        float nearest = anywhere;
        float farthest = -anywhere;
        for (int i = 0; i < along * along; ++i) {
            vec4 there = texelFetch(seen, first + ivec2(i % along, i / along), 0);
            float way = way_to(there.xyz);
            nearest = there.w > 0.5 ? min(nearest, way) : nearest;
            farthest = there.w > 0.5 ? max(farthest, way) : farthest;
        }
        float between = 0.5 * (nearest + farthest);
        SeenSamples half_of = farther > 0.5 ? samples_between(first, between, anywhere) : samples_between(first, -anywhere, between);
        half_of.cells = max(half_of.cells, pixel / (0.6 * cell_length * pixels_over_samples()));
        all = half_of.share > 0.0 ? half_of : all;
    }
    return all;
}
