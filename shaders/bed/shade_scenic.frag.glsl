#version 330 core
// The display colour of the bed as seen by the eye, one texel a place: shaded here once, then only
// looked up by the samples of the picture.
#include "common/colour.glsl"
#include "common/light.glsl"
#include "common/oren_nayar.glsl"
#include "bed/bed.glsl"
#include "bed/ground.glsl"
#include "bed/drape.glsl"

in vec2 position;
out vec4 colour;

void main() {
    BedPoint point = bed_point(position);
    vec2 world = (position - 0.5) * extent;
    vec3 world_point = vec3(world, 0.0);
    vec3 to_eye = direction_to_eye(world_point);
    Laid laid = drape_at(position, vec2(0.0));
    vec3 light = ground_light(with_drape(ground_albedo(position, point), laid), point, to_eye, 1.0);
    vec3 displayed = display_from_linear(tone_curve(with_haze(light, world_point, -to_eye)));
    colour = vec4(as_it_is(displayed, laid, 1.0), (1.0 - laid.share) * sand_on_board(texture(value_map, position).r));
}
