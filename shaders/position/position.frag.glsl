#version 330 core
// What a pixel sees at its middle: a point and, beside the bed's own surface, which way it faces: on an octahedron unfolded
// (Cigolle et al. 2014), two numbers of 12 bits in one, below 0.
in vec3 point;
in vec3 facing;  // 0: the bed's surface
out vec4 surface_position;

void main() {
    surface_position = vec4(point, 1.0);
    float size = abs(facing.x) + abs(facing.y) + abs(facing.z);
    if (size == 0.0) return;
    vec2 flat_part = facing.xy / size;
    if (facing.z < 0.0) {
        vec2 way = vec2(flat_part.x < 0.0 ? -1.0 : 1.0, flat_part.y < 0.0 ? -1.0 : 1.0);
        flat_part = (1.0 - abs(flat_part.yx)) * way;
    }
    vec2 steps = floor(flat_part * 2047.0 + 2047.5);
    surface_position.w = -(1.0 + steps.x * 4096.0 + steps.y);
}
