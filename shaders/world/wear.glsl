// What weather and wind have made of rock: pavement, where that is asked for and the ground is level. Needs world/rock.glsl,
// world/pavement.glsl and world/world.glsl before it.
void wear(inout vec3 normal, inout vec3 albedo, SurfacePoint at, float rocky, float steep) {
    vec3 place = in_metres(at.offset);
    float footprint = metres(length(at.along) + length(at.up));
    float level = paved * (1.0 - smoothstep(0.3, 0.6, steep));
    weather(normal, albedo, place, footprint, rocky * (1.0 - level));
    if (paved > 0.5) pave(normal, albedo, place.xy, wind, footprint, rocky * level);
}
