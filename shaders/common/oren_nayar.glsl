// Light a rough surface scatters towards the eye, over what a Lambert surface would (Oren & Nayar
// 1994, their qualitative model), for roughness σ = 0.5.
float oren_nayar(float n_dot_l, float n_dot_v, float l_dot_v) {
    const float variance = 0.25;
    const float a = 1.0 - 0.5 * variance / (variance + 0.33);
    const float b = 0.45 * variance / (variance + 0.09);
    float s = l_dot_v - n_dot_l * n_dot_v;
    float t = s > 0.0 ? max(max(n_dot_l, n_dot_v), 1e-3) : 1.0;
    return n_dot_l * (a + b * s / t);
}
