#version 330 core
// A box around each print and the ground that it marks, and a few samples more, so that only samples near a print are
// looked at: 36 corners of each, no buffers of theirs.
uniform mat4 clip;          // of places as `anchor` counts them
uniform vec2 picture_size;  // of a tile in the picture, see common/snap.glsl
uniform vec2 tile_corner;
uniform vec2 tile_size;
uniform vec3 anchor;       // which roots count from
uniform vec3 eye_position;    // counted likewise
uniform float curvature;   // of the planet, 1 / (2 R)
uniform float metre;       // block lengths
uniform float angle;       // between two samples

in vec4 root;   // and unevenness
in vec4 form;   // heading, side, metres deep
in vec4 slope;  // of the ground, east and north, and whether the print is shown
flat out vec3 print_root;
flat out vec4 print_form;
flat out vec4 print_ground;  // its slope, how far the print has slid, and unevenness

// Each digit: 1 east, 2 north, 4 up; counter-clockwise from outside.
const int corners[36] = int[36](0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5);

const float finest = 4.0;  // metres that a sample spans, at which a track is no longer seen

void main() {
    vec3 at = anchor + root.xyz;
    at.z -= dot(at.xy - eye_position.xy, at.xy - eye_position.xy) * curvature;
    print_root = at;
    print_form = form;
    // Sand begins to slide from under a foot on slopes of 24 degrees; on those of 30 it does everywhere.
    float slid = smoothstep(0.44, 0.58, length(slope.xy));
    print_ground = vec4(slope.xy, slid, root.w);

    int corner = corners[gl_VertexID];
    vec3 share = 2.0 * vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2)) - 1.0;
    float spread = angle * length(at - eye_position);
    float steep = length(slope.xy);
    vec2 down = -slope.xy / max(steep, 0.1);
    float half_width = metre * mix(0.30, 0.62, slid);
    at += metre * 0.3 * slid * vec3(down, -steep);
    at += share * (vec3(vec2(half_width), half_width * steep + 0.06 * metre) + 2.0 * spread);
    vec4 position = clip * vec4(at, 1.0);
    vec2 seen = (0.5 * position.xy + 0.5 * position.w) * picture_size - tile_corner * position.w;
    bool shown = slope.z > 0.5 && spread < finest * metre;
    gl_Position = shown ? vec4(2.0 * seen / tile_size - position.w, 0.0, position.w) : vec4(2.0, 2.0, 2.0, 1.0);
}
