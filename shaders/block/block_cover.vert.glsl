#version 330 core
// A box around the whole block, so that only pixels that may see it are looked at: 36 corners, no buffers.
uniform mat4 clip_from_world;
uniform vec2 picture_size;  // of a tile in the picture, see common/snap.glsl
uniform vec2 tile_corner;
uniform vec2 tile_size;
uniform vec3 lowest;
uniform vec3 highest;

// Each digit: 1 east, 2 north, 4 up; counter-clockwise from outside.
const int corners[36] = int[36](0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5);

void main() {
    int corner = corners[gl_VertexID];
    vec3 share = vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2));
    vec4 clip = clip_from_world * vec4(mix(lowest, highest, share), 1.0);
    vec2 at = (0.5 * clip.xy + 0.5 * clip.w) * picture_size - tile_corner * clip.w;
    gl_Position = vec4(2.0 * at / tile_size - clip.w, 0.0, clip.w);
}
