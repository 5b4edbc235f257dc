#include "render/frame/view_uniforms.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/elementary.h"
#include "render/colour/colouring.h"
#include "render/colour/sand_colours.h"
#include "render/frame/clouds.h"
#include "render/light/exposure_meter.h"
#include "render/light/haze.h"
#include "render/light/view_light.h"
#include "render/view/tile_warp.h"

namespace fumon {

namespace {

// Of the glare close to the disc (shaders/common/light.glsl), over the light: a camera's by day,
// and what is left of it beside the moon.
constexpr float bloom_of_sun = 1.7e-6F;
constexpr float bloom_of_moon = 2e-7F;

Tone chosen_tone(const LookSettings& look, const Light& light) {
    if (look.tone != Tone::automatic && look.tone != Tone::automatic_0_2) return look.tone;
    const bool endless = look.ground == Ground::endless;
    const bool automatic = look.tone == Tone::automatic;
    if (automatic && endless && look.cover == LandCover::automatic) return Tone::filmic;
    const bool punchy = endless || (automatic && light.atmosphere);
    return punchy ? Tone::agx_punchy : Tone::filmic;
}

/// Of light before the tone curve.
struct Rendering {
    double contrast = 1.0;
    double stops = 0.0;
    bool toe = false;  ///< less contrast in shade
};

/// How far red sand stands out from grey, 0 … 1. A power of each channel deepens its colour too.
double depth_of_colour(const SandColours& sand) {
    const double saturation = 1.0 - static_cast<double>(sand.crest.b / sand.crest.r);
    constexpr double as_quartz = 0.6;
    constexpr double as_iron_red = 0.8;
    return std::clamp((saturation - as_quartz) / (as_iron_red - as_quartz), 0.0, 1.0);
}

/// As a photograph of a desert under a low sun is developed, with contrast: slopes that face
/// the sun are then far brighter than the level ground that the light's exposure is for. A high
/// sun, night, clouds, red sand and other planets need less.
Rendering chosen_rendering(const View& view, const Light& light) {
    const LookSettings& look = view.look;
    if (look.ground != Ground::endless) {
        constexpr double around_a_block = 0.35;
        const bool brighter = look.tone == Tone::automatic && light.atmosphere;
        return {look.contrast.is_word() ? 1.0 : look.contrast.value,
                look.exposure + (brighter ? around_a_block : 0.0)};
    }
    if (!look.contrast.is_word()) return {look.contrast.value, look.exposure};
    // Grass and wet soil are dark, and walls in shade more so.
    if (look.cover == LandCover::automatic) return {1.12, look.exposure - 0.3};
    constexpr double low = 0.2;  // sines of elevations
    constexpr double high = 0.5;
    double share =
        std::clamp((high - static_cast<double>(light.to_sun.z)) / (high - low), 0.0, 1.0);
    if (!light.atmosphere || light.stars || view.air.planet != Planet::earth) share = 0.0;
    share *= 1.0 - depth_of_colour(sand_colours(look));
    return {1.35 + 0.45 * share, look.exposure - 0.5 * share,
            look.contrast.word == "auto" && !light.stars};
}

/// Where the air is bright enough to matter, for exposure and in the shade.
bool has_bright_air(const View& view, const Light& light) {
    return view.look.ground == Ground::endless && chosen_aerosol(view) == Aerosol::desert &&
           light.atmosphere && !light.stars;
}

float tone_number(Tone tone) {  // of common/colour.glsl
    return tone == Tone::filmic ? 0.0F : tone == Tone::neutral ? 2.0F : 1.0F;
}

float switched(bool on) {
    return on ? 1.0F : 0.0F;
}

/// Of the air, per block length (Koschmieder 1924: contrast falls to 2 % within the visibility);
/// below 0 where the haze does not follow distance.
float extinction(const View& view, const Camera& camera, const Block& block, const Haze& haze) {
    const bool known = !view.air.visibility.is_word();
    if (!known && view.look.ground != Ground::endless) return -1.0F;
    if (!camera.perspective) return 0.0F;
    return static_cast<float>(extinction_from(camera.eye, haze, view, block));
}

}  // namespace

float sample_share(const View& view) {
    if (!view.camera.has_lens()) return 1.0F;
    return 1.0F / static_cast<float>(view.image.supersampling);
}

gl::TextureLayout colour_layout(PixelFormat kind) {
    gl::TextureLayout layout;
    if (kind == PixelFormat::display_16)
        layout = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
    if (kind == PixelFormat::radiance)
        layout = {GL_RGBA16F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
    return layout;
}

gl::Constants fixed_uniforms(const View& view, const Light& light, const Block& block,
                             PixelFormat kind) {
    constexpr float no_curve = 3.0F;  // of common/colour.glsl
    const bool linear = kind == PixelFormat::radiance;
    const Tone tone = chosen_tone(view.look, light);
    const bool scenic = view.look.mode == ViewMode::scenic;
    gl::Constants constants{
        {"tone", linear ? no_curve : tone_number(tone)},
        {"linear_light", switched(linear)},
        {"sample_share", sample_share(view)},
        {"samples_along",
         view.camera.has_lens() ? 1.0F : static_cast<float>(view.image.supersampling)},
        {"dithered", switched(kind == PixelFormat::display_8)},
        {"punch", switched(tone == Tone::agx_punchy)},
        {"toe", switched(chosen_rendering(view, light).toe)},
        {"atmosphere", switched(light.atmosphere)},
        {"studio", switched(light.studio)},
        {"parallel", switched(view.camera.projection != Projection::perspective)},
        {"natural", switched(view.look.colour_by == Colouring::natural)},
        {"marks", mark_number(view.look.mark)},
        {"paved", switched(view.look.rock == RockSurface::pavement)},
        {"tinted", switched(!colours_water(view.look.colour_by))},
        {"figure", switched(view.look.mode == ViewMode::figure)},
        {"clear", switched(view.look.relief == FigureRelief::clear)},
        {"soil", switched(view.look.sides == BlockSides::soil && scenic)},
        {"plaster", switched(view.look.sides == BlockSides::plain && scenic)},
        {"strata", switched(view.look.strata)},
        {"bedded", switched(view.look.strata || !block.tiles.plain || block.rock <= 0.0)},
        {"blue_green", switched(view.look.water_tint == WaterTint::blue_green)},
        {"plain", switched(block.tiles.plain)},
        {"varied", switched(tiles_are_warped(view, !block.tiles.plain))},
        {"clouds", cloud_number(view, light)},
        {"rock", static_cast<float>(block.rock)},
        {"covered", switched(view.look.cover != LandCover::bare)},
        {"draped", switched(view.laid() != nullptr)},
        {"drape_as_it_is", switched(view.look.drape_light == DrapeLight::as_it_is)},
        {"streamers", switched(view.streamers.strength > 0.0)}};
    if (view.look.ground != Ground::endless) {
        // Others are numbers, by which a compiler may calculate otherwise.
        if (chosen_rendering(view, light).contrast == 1.0) constants.push_back({"contrast", 1.0F});
        if (view.air.visibility.is_word()) constants.push_back({"extinction", -1.0F});
    }
    return constants;
}

double metered_exposure(const View& view, const Light& light, const Camera& camera) {
    return has_bright_air(view, light) ? exposure_under_sky(light, camera) : 1.0;
}

void set_light(const gl::Program& program, const View& view, const Light& light,
               const Camera& camera, const Block& block) {
    const Tone tone = chosen_tone(view.look, light);
    program.set("tone", static_cast<int>(tone_number(tone)));
    program.set("punch", switched(tone == Tone::agx_punchy));
    const Rendering rendering = chosen_rendering(view, light);
    program.set("exposure", static_cast<float>(light.metered *
                                               elementary::exp(std::numbers::ln2 *
                                                               (rendering.stops + light.stops))));
    program.set("contrast", static_cast<float>(rendering.contrast));
    program.set("toe", switched(rendering.toe));
    program.set("to_sun", light.to_sun);
    program.set("sun_light", light.sun);
    program.set("visible_sun", light.visible_sun);
    program.set("bloom", light.stars ? bloom_of_moon : bloom_of_sun);
    program.set("sky_light", light.sky);
    program.set("in_air", light.in_air);
    program.set("haze_colour", light.haze);
    program.set("glow_colour", light.glow);
    program.set("zenith_colour", light.zenith);
    program.set("atmosphere", light.atmosphere ? 1.0F : 0.0F);
    program.set("studio", switched(light.studio));
    program.set("sky_lean_x", light.sky_lean[0]);
    program.set("sky_lean_xx", light.sky_lean[1]);
    program.set("sky_lean_t", light.sky_lean[2]);
    program.set("sky_lean_tx", light.sky_lean[3]);
    program.set("sky_map", sky_unit);
    program.set("eye", glm::vec3(camera.eye));
    program.set("eye_axis", glm::vec3(-camera.forward));
    program.set("parallel", camera.perspective ? 0.0F : 1.0F);
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& corner : block_corners(block)) {
        const double depth = glm::dot(corner, camera.forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    const double scale = 1.0 / std::max(farthest - nearest, 1e-6);
    program.set("depth_plane", glm::vec4(camera.forward * scale, -nearest * scale));
    const double left = camera.perspective ? std::max(1.0 - view.sun.haze, 0.02) : 1.0;
    const Haze haze = haze_of(view, block);
    const float by_distance = extinction(view, camera, block, haze);
    program.set("haze_log",
                by_distance >= 0.0F ? -1.0F : static_cast<float>(elementary::log(left)));
    program.set("extinction", by_distance);
    program.set("haze_bands", glm::vec3(haze.bands));
    program.set("haze_eye", glm::vec3(camera.eye));
    // Half of how high crests stand over the rest: the mean of the shade behind them.
    program.set("shaded_height", has_bright_air(view, light)
                                     ? static_cast<float>(0.5 * (block.top - block.surface))
                                     : 0.0F);
    set_clouds(program, view, light, camera, block);
}

void set_sand(const gl::Program& program, const LookSettings& look) {
    const SandColours sand = sand_colours(look);
    program.set("sand_crest", sand.crest);
    program.set("sand_trough", sand.trough);
}

}  // namespace fumon
