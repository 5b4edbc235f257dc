// Tongues of sand that slid down a steep face. Needs world/world.glsl before it.
uniform sampler2D slip_map;  // of world/slip_face.frag.glsl
uniform vec2 slip_size;      // of its sides, metres: across a face, and up it

// Slope of them, east and north, and how much lighter they are. They run straight down the faces of sixteen directions;
// between two of these both are mixed. Along a face that turns, tongues of its own direction would slip. `across`: a unit
// vector along the face, uphill to its left.
vec3 tongues(SeenPlace at, vec2 across) {
    const float up_the_face = 1.85;  // of a height, at the angle of repose
    float sixteenths = atan(across.y, across.x) * (8.0 / 3.14159265);
    float nearest = floor(sixteenths);
    float share = smoothstep(0.35, 0.65, sixteenths - nearest);
    vec3 place = in_metres(at.offset);
    vec2 texels = vec2(textureSize(slip_map, 0)) / slip_size;
    const float sixteenth = 3.14159265 / 8.0;
    const mat2 next = mat2(0.92387953, 0.38268343, -0.38268343, 0.92387953);
    vec2 level = vec2(cos(nearest * sixteenth), sin(nearest * sixteenth));
    vec2 scale = texels * metres(1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        float number = nearest + float(i);
        vec2 on_face = vec2(dot(place.xy, level), up_the_face * place.z);
        vec2 along = scale * vec2(dot(at.along.xy, level), up_the_face * at.along.z);
        vec2 up = scale * vec2(dot(at.up.xy, level), up_the_face * at.up.z);
        float a = dot(along, along);
        float b = dot(up, up);
        float seen = max(min(a, b), 0.2 * max(a, b));
        vec3 face = textureLod(slip_map, on_face / slip_size + vec2(0.31, 0.17) * mod(number, 16.0), 0.5 * log2(max(seen, 1e-9))).rgb;
        vec2 slope = 0.8 * face.xy - 0.4;
        sum += (i == 0 ? 1.0 - share : share) * vec3(slope.x * level + slope.y * vec2(level.y, -level.x), 2.0 * face.z - 1.0);
        level = next * level;
    }
    return sum;
}
