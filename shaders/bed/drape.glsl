// A picture laid over the bed. Needs common/colour.glsl and bed/bed.glsl before it.
uniform float draped;          // 1: there is one
uniform float drape_as_it_is;  // 1: seen in its own light alone
uniform float drape_strength;
uniform sampler2D drape_map;   // display values times opacity, and that; see render/bed/drape_texture.h
uniform vec2 drape_share;      // of the ground's tile, that the bed covers
uniform vec2 drape_origin;     // of the drawn bed, in the bed
uniform vec2 drape_texel;      // of what is shaded, of the bed's sides; 0 for pixels

// Light of the drape, and how far it hides the ground.
struct Laid {
    vec3 light;
    float share;
};

// How far ways over the maps reach over the drape.
vec2 drape_way(vec2 way) { return plain < 0.5 ? way : way * vec2(2.0, 1.0) / drape_share; }

vec4 drape_lookup(vec2 at, float level) {
    vec4 texel = textureLod(drape_map, at, level);
    if (plain < 0.5) return texel;
    // A bed that ends is there once. Its edge is as wide as what is looked at.
    vec2 width = exp2(level) / vec2(textureSize(drape_map, 0));
    vec2 inside = clamp((0.5 - abs(at - 0.5)) / width + 0.5, 0.0, 1.0);
    return texel * (inside.x * inside.y);
}

vec2 drape_position(vec2 position) {
    if (plain < 0.5) return position + drape_origin;
    if (position.x >= 0.5) return vec2(-2.0);
    return (vec2(2.0 * position.x, position.y) - 0.5) / drape_share + 0.5;
}

Laid laid_of(vec4 texel) {
    vec3 own = texel.a > 0.0 ? min(texel.rgb / texel.a, 1.0) : vec3(0.0);
    return Laid(linear_from_display(own), drape_strength * texel.a);
}

const Laid nothing_laid = Laid(vec3(0.0), 0.0);

// At a place of the maps, over a width of the bed's sides.
Laid drape_at(vec2 position, vec2 width) {
    if (draped < 0.5) return nothing_laid;
    vec2 texels = max(width, drape_texel) * vec2(textureSize(drape_map, 0));
    return laid_of(drape_lookup(drape_position(position), log2(max(max(texels.x, texels.y), 1.0))));
}

// The mean over what a sample sees of ground that lies aslant to the view: of four places along it, which `along` and
// `across` lead over in the maps.
Laid slanting_drape(vec2 position, vec2 along, vec2 across) {
    if (draped < 0.5) return nothing_laid;
    vec2 size = vec2(textureSize(drape_map, 0));
    vec2 longer = drape_way(along);
    vec2 shorter = drape_way(across);
    if (length(longer * size) < length(shorter * size)) {
        vec2 other = longer;
        longer = shorter;
        shorter = other;
    }
    float texels = max(0.25 * length(longer * size), length(shorter * size));
    float level = log2(max(texels, 1.0));
    vec2 at = drape_position(position);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) sum += 0.25 * drape_lookup(at + (0.25 * float(i) - 0.375) * longer, level);
    return laid_of(sum);
}

vec3 with_drape(vec3 albedo, Laid laid) { return mix(albedo, laid.light, laid.share); }

// A colour as it is displayed, and over it a drape in its own light, as far as `share` lets it be seen.
vec3 as_it_is(vec3 displayed, Laid laid, float share) {
    if (draped < 0.5) return displayed;
    return mix(displayed, display_from_linear(laid.light), drape_as_it_is * laid.share * share);
}
