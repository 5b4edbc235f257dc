// The colour of the block's surface at a place (0 … 1).
uniform sampler2D shaded;  // alpha: how much of the grain is seen
uniform sampler2D grain;
uniform vec2 grain_scale;
uniform float grain_strength;

vec3 surface_colour(vec2 place, float speck) {
    vec4 ground = texture(shaded, place);
    return ground.rgb * (1.0 + grain_strength * ground.a * (speck - 0.5));
}
