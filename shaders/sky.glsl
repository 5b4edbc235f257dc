// The clear sky stands in light.glsl.
