#version 330 core
in vec2 in_shadow;
in vec3 left;
in float strength;
out vec4 colour;

void main() {
    float across = 1.0 - in_shadow.x * in_shadow.x;
    float along = smoothstep(0.0, 0.18, in_shadow.y) * (1.0 - in_shadow.y) * (1.0 - 0.3 * in_shadow.y);
    colour = vec4(mix(vec3(1.0), left, clamp(1.3 * strength * across * along, 0.0, 0.85)), 1.0);
}
