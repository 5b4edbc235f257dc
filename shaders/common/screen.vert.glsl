#version 330 core
// One triangle that covers the whole target; needs no buffers.
out vec2 position;  // 0 … 1 over the target

void main() {
    position = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(2.0 * position - 1.0, 0.0, 1.0);
}
