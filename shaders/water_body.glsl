// The light that a deep body of water sends back.
uniform float turbidity;  // 0 clear … 1 muddy

vec3 water_body_colour() { return mix(vec3(0.018, 0.105, 0.140), vec3(0.30, 0.185, 0.085), turbidity); }
