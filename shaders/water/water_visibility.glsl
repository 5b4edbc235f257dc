// Places that the samples of a pixel see. Needs bed/bed.glsl and bed/soil.glsl before it.
uniform sampler2D visibility;  // of block/visibility_surface.frag.glsl
uniform vec2 height_span;     // of the surface: the lowest, and how much higher the highest
uniform float samples_along;  // samples along each side of a pixel
uniform vec2 sample_offset;   // of the first pixel's first sample

// Between samples: up to there, in cells of the maps or in widths of a pixel, one place stands for all.
uniform float split_distance_cells;
uniform float split_distance_pixels;

struct PixelSamples {
    vec3 mean;    // their place, 0 … 1, as in `visibility`
    float cells;  // how far they lie apart, in cells of the maps
    float share;  // of the samples that see the surface
};

vec3 point_at(vec3 position) { return vec3((position.xy - 0.5) * extent, height_span.x + height_span.y * position.z); }

float view_distance(vec3 position) { return mix(distance(eye, point_at(position)), -dot(eye_axis, point_at(position)), parallel); }

// For how far apart the samples are, the samples' own sizes included.
float pixels_over_samples() { return samples_along / max(samples_along - 1.0, 1.0); }

float level_over(PixelSamples samples) { return log2(max(0.6 * samples.cells * pixels_over_samples(), 1.0)); }

ivec2 first_sample() { return ivec2(gl_FragCoord.xy) * int(samples_along) + ivec2(sample_offset); }

vec4 sample_of(ivec2 first, int number) { return texelFetch(visibility, first + ivec2(number % int(samples_along), number / int(samples_along)), 0); }

// Samples taken one by one: alpha is 1 where they count, else 0.
struct Taken {
    vec4 sum;
    vec2 least;
    vec2 most;
};

Taken none_taken() { return Taken(vec4(0.0), vec2(2.0), vec2(-1.0)); }

void take(inout Taken taken, vec4 there) {
    float none = 2.0 * (1.0 - there.w);
    taken.sum += vec4(there.w * there.xyz, there.w);
    taken.least = min(taken.least, there.xy + none);
    taken.most = max(taken.most, there.xy - none);
}

PixelSamples samples_of(Taken taken, float all) {
    vec2 apart = max(taken.most - taken.least, vec2(0.0)) * vec2(textureSize(lighting_map, 0));
    return PixelSamples(taken.sum.xyz / max(taken.sum.w, 1.0), max(apart.x, apart.y), taken.sum.w / max(all, 1.0));
}

// All of a pixel.
PixelSamples pixel_samples() {
    Taken taken = none_taken();
    for (int i = 0; i < int(samples_along) * int(samples_along); ++i) take(taken, sample_of(first_sample(), i));
    return samples_of(taken, taken.sum.w);
}

float cell_length() { return extent.x / float(textureSize(lighting_map, 0).x); }

// Whether they see two places far apart, as at a brink before far ground, so that each is shaded by itself.
bool are_far_apart(PixelSamples all) {
    return all.cells > split_distance_cells && all.cells * cell_length() > split_distance_pixels * pixel_width_at(point_at(all.mean));
}

// The nearer (`farther` 0) or the farther (1) of all the samples of such a pixel.
PixelSamples half_of_samples(PixelSamples all, float farther) {
    float nearest = 1e30;
    float farthest = -1e30;
    for (int i = 0; i < int(samples_along) * int(samples_along); ++i) {
        vec4 there = sample_of(first_sample(), i);
        float way = view_distance(there.xyz);
        nearest = there.w > 0.5 ? min(nearest, way) : nearest;
        farthest = there.w > 0.5 ? max(farthest, way) : farthest;
    }
    float between = 0.5 * (nearest + farthest);
    Taken taken = none_taken();
    float count = 0.0;
    for (int i = 0; i < int(samples_along) * int(samples_along); ++i) {
        vec4 there = sample_of(first_sample(), i);
        count += there.w;
        if ((view_distance(there.xyz) >= between) != (farther > 0.5)) there.w = 0.0;
        take(taken, there);
    }
    PixelSamples half_of = samples_of(taken, count);
    half_of.cells = max(half_of.cells, pixel_width_at(point_at(all.mean)) / (0.6 * cell_length() * pixels_over_samples()));
    return half_of;
}
