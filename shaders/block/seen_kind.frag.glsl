#version 330 core
// What a sample sees and where, in one number for block/block_samples.glsl.
uniform int kind;  // above 0

in vec2 at_sample;  // 0 … 1
out uint seen;

void main() {
    ivec2 steps = ivec2(clamp(at_sample, 0.0, 1.0) * vec2(32767.0, 16383.0) + 0.5);
    seen = uint((kind << 29) | (steps.x << 14) | steps.y);
}
