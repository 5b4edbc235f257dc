// Clip coordinates of one tile from those of the whole picture. Corners are set on 1/256 of a sample
// counted over the whole picture, so that every tile cuts the same triangles into the same samples.
uniform vec2 picture_size;  // samples
uniform vec2 tile_corner;   // samples; where this tile begins
uniform vec2 tile_size;     // samples; a power of two

vec4 snapped(vec4 clip) {
    vec2 sample_coord = (clip.xy / clip.w * 0.5 + 0.5) * picture_size;
    sample_coord = floor(sample_coord * 256.0 + 0.5) / 256.0 - tile_corner;
    return vec4((sample_coord / tile_size * 2.0 - 1.0) * clip.w, clip.zw);
}
