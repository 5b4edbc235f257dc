// Tongues of sand that slid down a steep face. Needs world/world.glsl before it.
uniform sampler2D slip_map;  // of world/slip_face.frag.glsl
uniform vec2 slip_size;      // of its sides, metres: across a face, and up it

// The sixteenth of all directions in which one lies.
struct Sixteenth {
    float number;  // −8 … 7, counted from the first axis
    vec2 begin;    // where it begins, a unit vector
    float share;   // 0 … 1, of the way through it
};

// Of a unit vector. By halves: an arcus tangent, a cosine and a sine would take four times as long.
Sixteenth sixteenth_of(vec2 way) {
    const float root = 0.70710678;
    const vec2 first = vec2(0.92387953, 0.38268343);  // where the next one begins
    bool behind = way.y < 0.0;
    if (behind) way = -way;
    bool quarter = way.x < 0.0;
    if (quarter) way = vec2(way.y, -way.x);
    bool eighth = way.y > way.x;
    if (eighth) way = root * vec2(way.x + way.y, way.y - way.x);
    bool last = way.y * first.x > way.x * first.y;
    if (last) way = vec2(dot(way, first), way.y * first.x - way.x * first.y);
    vec2 begin = last ? first : vec2(1.0, 0.0);
    if (eighth) begin = root * vec2(begin.x - begin.y, begin.x + begin.y);
    if (quarter) begin = vec2(-begin.y, begin.x);
    if (behind) begin = -begin;
    float number = (behind ? -8.0 : 0.0) + (quarter ? 4.0 : 0.0) + (eighth ? 2.0 : 0.0) + (last ? 1.0 : 0.0);
    // The sine of what is left is less than 0.39; an arcus sine's next term is a thousandth of a sixteenth at most.
    float s2 = way.y * way.y;
    return Sixteenth(number, begin, way.y * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) * (8.0 / 3.14159265));
}

// Slope of them, east and north, and how much lighter they are. They run straight down the faces of sixteen directions;
// between two of these both are mixed. Along a face that turns, tongues of its own direction would slip. `across`: a unit
// vector along the face, uphill to its left.
vec3 tongues(SurfacePoint at, vec2 across) {
    const float up_the_face = 1.85;  // of a height, at the angle of repose
    const mat2 next = mat2(0.92387953, 0.38268343, -0.38268343, 0.92387953);
    Sixteenth own = sixteenth_of(across);
    float share = smoothstep(0.35, 0.65, own.share);
    vec3 position = in_metres(at.offset);
    vec2 per_metre = 1.0 / slip_size;
    vec2 scale = vec2(textureSize(slip_map, 0)) * per_metre * metres(1.0);
    vec2 level = own.begin;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        float number = own.number + float(i);
        vec2 on_face = vec2(dot(position.xy, level), up_the_face * position.z);
        vec2 along = scale * vec2(dot(at.along.xy, level), up_the_face * at.along.z);
        vec2 up = scale * vec2(dot(at.up.xy, level), up_the_face * at.up.z);
        float a = dot(along, along);
        float b = dot(up, up);
        float seen = max(min(a, b), 0.2 * max(a, b));
        vec3 face = textureLod(slip_map, on_face * per_metre + vec2(0.31, 0.17) * mod(number, 16.0), 0.5 * log2(max(seen, 1e-9))).rgb;
        vec2 slope = 0.8 * face.xy - 0.4;
        sum += (i == 0 ? 1.0 - share : share) * vec3(slope.x * level + slope.y * vec2(level.y, -level.x), 2.0 * face.z - 1.0);
        level = next * level;
    }
    return sum;
}
