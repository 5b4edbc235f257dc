#include "render/bed_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/compensated_sum.h"
#include "base/elementary.h"
#include "numerics/resampling.h"
#include "render/clouds.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/colour/sand_colours.h"
#include "render/view/far_copies.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

constexpr int enough_texels = 1024;  // along the longer side of the shaded bed, if it is small
// Of ground under water: to a pixel at most so many, along the longer side, and in what is seen.
constexpr double finest_shown = 1.0;
constexpr double most_texels_across = 4096;
constexpr double most_texels_seen = 2e6;
constexpr int coarsest_seen = 3;  // mipmap: at an edge the samples' places are no neighbours
constexpr double texels_per_sample = 1.3;  // beyond which mipmaps are needed against shimmer
constexpr double natural_spread = 2.2;     // standard deviations from trough to crest, half of it
constexpr double least_natural_range = 0.03;  // of the longer side: a nearly flat bed stays even

const gl::TextureLayout lighting_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                        GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};
const gl::TextureLayout value_layout{GL_R16,    GL_RED, GL_UNSIGNED_SHORT,
                                     GL_LINEAR, 0,      GL_CLAMP_TO_EDGE};
const gl::TextureLayout mark_layout{GL_R8,      GL_RED, GL_UNSIGNED_BYTE,
                                    GL_NEAREST, 0,      GL_CLAMP_TO_EDGE};
const gl::TextureLayout palette_layout{GL_RGB8,   GL_RGB, GL_UNSIGNED_BYTE,
                                       GL_LINEAR, 0,      GL_CLAMP_TO_EDGE};

/// Of a bed that is repeated, where it is endless.
gl::TextureLayout repeated(gl::TextureLayout layout, Ground ground) {
    if (ground == Ground::endless) {
        layout.wrap = GL_REPEAT;
        layout.minification = GL_LINEAR_MIPMAP_LINEAR;
        layout.coarsest = gl::TextureLayout{}.coarsest;
    }
    return layout;
}

/// Plants and rock pass into sand, other marks end with their cell.
gl::TextureLayout layout_of(const LookSettings& look) {
    gl::TextureLayout layout = mark_layout;
    if (look.mark != Marking::ground) return layout;
    layout.filter = GL_LINEAR;
    if (look.ground == Ground::endless) layout.wrap = GL_REPEAT;
    return layout;
}

constexpr int noise_texels = 512;  // along the longer side: a dozen to the finest feature
const gl::TextureLayout noise_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                     GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};

/// The colours of endless ground are lit later: a byte's step of a dark one is two levels of the
/// picture, and falls elsewhere on a bed that is shifted.
gl::TextureLayout shaded_layout(Ground ground, bool mipmaps, PixelKind kind) {
    gl::TextureLayout layout =
        colour_layout(ground == Ground::endless ? PixelKind::display_16 : kind);
    if (mipmaps) layout.minification = GL_LINEAR_MIPMAP_LINEAR;
    layout.coarsest = coarsest_seen;
    return layout;
}

/// Texels along the longer side: as the bed has, or more for a small bed in a large picture.
int longer_shaded_side(const DisplayBed& bed, int samples_across) {
    const int wanted =
        std::min(enough_texels, static_cast<int>(texels_per_sample * samples_across));
    return std::max({bed.z.nx(), bed.z.ny(), wanted});
}

int shaded_size(int count, const DisplayBed& bed, int samples_across) {
    const long longer = std::max(bed.z.nx(), bed.z.ny());
    return std::max(1, static_cast<int>(static_cast<long>(count) *
                                        longer_shaded_side(bed, samples_across) / longer));
}

const char* shader_of(const LookSettings& look, const Snapshot& first) {
    if (look.ground == Ground::endless) return "bed/shade_albedo.frag.glsl";
    if (look.mode == ViewMode::figure) return "bed/shade_figure.frag.glsl";
    return draws_water(look, first) ? "bed/shade_water.frag.glsl" : "bed/shade_scenic.frag.glsl";
}

/// 255 in the cells that get no palette place, 1 × 1 where all do.
Field<std::uint8_t> uncoloured_texels(Colouring colour_by, const Snapshot& snapshot) {
    if (!colours_water(colour_by)) return {1, 1, 0};
    Field<std::uint8_t> texels = dry_cells(snapshot);
    for (std::uint8_t& texel : texels.values()) texel = texel != 0 ? 255 : 0;
    return texels;
}

/// The range of heights over which natural sand goes from trough to crest.
std::pair<double, double> natural_range(const Snapshot& snapshot, const Block& block) {
    CompensatedSum sum;
    CompensatedSum squares;
    std::size_t count = 0;
    for (std::size_t i = 0; i < snapshot.bed.size(); ++i) {
        if (!snapshot.nodata.empty() && snapshot.nodata.values()[i] != 0) continue;
        const double height = snapshot.bed.values()[i] - block.reference;
        sum.add(height);
        squares.add(height * height);
        ++count;
    }
    if (count == 0) return {0.0, 1.0};
    const double mean = sum.value() / static_cast<double>(count);
    const double spread =
        std::sqrt(std::max(squares.value() / static_cast<double>(count) - mean * mean, 0.0));
    const double half =
        std::max(natural_spread * spread, 0.5 * least_natural_range / block.height_scale);
    return {block.reference + mean - half, block.reference + mean + half};
}

/// Palette places up to which ground between dunes is bare floor, and from which it is sand alone:
/// by the heights that a twentieth of the bed is below and above; and how far there is such ground
/// at all, since a bed that is nearly flat is all alike.
glm::vec3 floor_places(const Field<float>& values, std::pair<double, double> range) {
    std::vector<float> sorted(values.values().begin(), values.values().end());
    const auto at = [&](double share) {
        const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size()));
        std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
        return static_cast<double>(sorted[static_cast<std::size_t>(place)]);
    };
    const double low = (at(0.05) - range.first) / (range.second - range.first);
    const double span = (at(0.95) - range.first) / (range.second - range.first) - low;
    const double floors = std::clamp(5.0 * span - 0.5, 0.0, 1.0);
    return {low + 0.02 * span, low + std::max(0.2 * span, 0.01), floors};
}

Tone chosen_tone(const LookSettings& look) {
    if (look.tone != Tone::automatic) return look.tone;
    return look.ground == Ground::endless ? Tone::agx_punchy : Tone::filmic;
}

/// Of light before the tone curve.
struct Rendering {
    double contrast = 1.0;
    double stops = 0.0;
};

/// How far red sand stands out from grey, 0 … 1. A power of each channel deepens its colour too.
double depth_of_colour(const SandColours& sand) {
    const double saturation = 1.0 - static_cast<double>(sand.crest.b / sand.crest.r);
    constexpr double as_quartz = 0.6;
    constexpr double as_iron_red = 0.8;
    return std::clamp((saturation - as_quartz) / (as_iron_red - as_quartz), 0.0, 1.0);
}

/// As a photograph of a desert under a low sun is developed, with deep shadows: slopes that face
/// the sun are then far brighter than the level ground that the light's exposure is for. A high
/// sun, night, clouds, red sand and other planets need less.
Rendering chosen_rendering(const View& view, const Light& light) {
    const LookSettings& look = view.look;
    if (!look.contrast.is_word()) return {look.contrast.value, look.exposure};
    if (look.ground != Ground::endless) return {1.0, look.exposure};
    constexpr double low = 0.2;  // sines of elevations
    constexpr double high = 0.5;
    double share =
        std::clamp((high - static_cast<double>(light.to_sun.z)) / (high - low), 0.0, 1.0);
    if (!light.atmosphere || light.stars || view.air.planet != Planet::earth) share = 0.0;
    share *= 1.0 - depth_of_colour(sand_colours(look));
    return {1.35 + 0.45 * share, look.exposure - 0.5 * share};
}

float tone_number(Tone tone) {  // of common/colour.glsl
    return tone == Tone::filmic ? 0.0F : tone == Tone::neutral ? 2.0F : 1.0F;
}

float switched(bool on) {
    return on ? 1.0F : 0.0F;
}

/// Of the air, per block length (Koschmieder 1924: contrast falls to 2 % within the visibility);
/// below 0 where the haze does not follow distance.
float extinction(const View& view, const Camera& camera, const Block& block) {
    const bool known = !view.air.visibility.is_word();
    if (!known && view.look.ground != Ground::endless) return -1.0F;
    if (!camera.perspective) return 0.0F;
    return static_cast<float>(haze_per_kilometre(view, block) * block.kilometres);
}

}  // namespace

float sample_share(const View& view) {
    if (!view.camera.has_lens()) return 1.0F;
    return 1.0F / static_cast<float>(view.image.supersampling);
}

double haze_per_kilometre(const View& view, const Block& block) {
    // km; landscapes of many kilometres are looked at on clear days
    const double usual = block.tiles.plain ? std::max(40.0, 8.0 * block.kilometres) : 40.0;
    constexpr double contrast_log = 3.912;
    const double clear = usual * std::min(1.0, 2.0 / std::max(view.sun.dust, 1e-3));
    const double visibility = view.air.visibility.is_word() ? clear : view.air.visibility.value;
    return contrast_log / visibility;
}

gl::TextureLayout colour_layout(PixelKind kind) {
    gl::TextureLayout layout;
    if (kind == PixelKind::display_16)
        layout = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
    if (kind == PixelKind::radiance)
        layout = {GL_RGBA16F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
    return layout;
}

gl::Constants fixed_uniforms(const View& view, const Light& light, const Block& block,
                             PixelKind kind) {
    constexpr float no_curve = 3.0F;  // of common/colour.glsl
    const bool linear = kind == PixelKind::radiance;
    const Tone tone = chosen_tone(view.look);
    const bool scenic = view.look.mode == ViewMode::scenic;
    gl::Constants constants{
        {"tone", linear ? no_curve : tone_number(tone)},
        {"linear_light", switched(linear)},
        {"sample_share", sample_share(view)},
        {"dithered", switched(kind == PixelKind::display_8)},
        {"punch", switched(tone == Tone::agx_punchy)},
        {"atmosphere", switched(light.atmosphere)},
        {"parallel", switched(view.camera.projection != Projection::perspective)},
        {"natural", switched(view.look.colour_by == Colouring::natural)},
        {"marks", mark_number(view.look.mark)},
        {"tinted", switched(!colours_water(view.look.colour_by))},
        {"figure", switched(view.look.mode == ViewMode::figure)},
        {"soil", switched(view.look.sides == BlockSides::soil && scenic)},
        {"plain", switched(block.tiles.plain)},
        {"varied", switched(far_copies_vary(view, !block.tiles.plain))},
        {"clouds", cloud_number(view, light)},
        {"rock", static_cast<float>(block.rock)},
        {"streamers", switched(view.streamers.strength > 0.0)}};
    if (view.look.ground != Ground::endless) {
        // Others are numbers, by which a compiler may calculate otherwise.
        if (chosen_rendering(view, light).contrast == 1.0) constants.push_back({"contrast", 1.0F});
        if (view.air.visibility.is_word()) constants.push_back({"extinction", -1.0F});
    }
    return constants;
}

void set_light(const gl::Program& program, const View& view, const Light& light,
               const Camera& camera, const Block& block) {
    const Tone tone = chosen_tone(view.look);
    program.set("tone", static_cast<int>(tone_number(tone)));
    program.set("punch", switched(tone == Tone::agx_punchy));
    const Rendering rendering = chosen_rendering(view, light);
    program.set("exposure", static_cast<float>(elementary::exp(std::numbers::ln2 *
                                                               (rendering.stops + light.stops))));
    program.set("contrast", static_cast<float>(rendering.contrast));
    program.set("to_sun", light.to_sun);
    program.set("sun_light", light.sun);
    program.set("sun_seen", light.sun_seen);
    program.set("bloom", light.stars ? 2e-7F : 1.7e-6F);
    program.set("sky_light", light.sky);
    program.set("haze_colour", light.haze);
    program.set("glow_colour", light.glow);
    program.set("zenith_colour", light.zenith);
    program.set("atmosphere", light.atmosphere ? 1.0F : 0.0F);
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
    const float by_distance = extinction(view, camera, block);
    program.set("haze_log",
                by_distance >= 0.0F ? -1.0F : static_cast<float>(elementary::log(left)));
    program.set("extinction", by_distance);
    program.set("haze_eye", glm::vec3(camera.eye));
    set_clouds(program, view, light, camera, block);
}

void set_sand(const gl::Program& program, const LookSettings& look) {
    const SandColours sand = sand_colours(look);
    program.set("sand_crest", sand.crest);
    program.set("sand_trough", sand.trough);
}

BedShading::BedShading(const View& view, const Block& block, const Snapshot& first,
                       const DisplayBed& first_bed, int samples_across, const gl::Constants& fixed,
                       const gl::MipmapMaker& mipmaps, PixelKind kind)
    : view_(view),
      block_(block),
      refinement_(first_bed.z.nx() / first.bed.nx()),
      mipmaps_(mipmaps),
      shaded_mipmaps_(view.look.ground == Ground::endless ||
                      longer_shaded_side(first_bed, samples_across) >
                          texels_per_sample * samples_across),
      program_("common/screen.vert.glsl", shader_of(view.look, first), {}, fixed),
      palette_(256, 1, palette_layout, chosen_palette(view.look).data()),
      lighting_(first_bed.z.nx(), first_bed.z.ny(), repeated(lighting_layout, view.look.ground)),
      values_(first_bed.z.nx(), first_bed.z.ny(), repeated(value_layout, view.look.ground)),
      marks_(view.look.mark == Marking::none ? 1 : first.bed.nx(),
             view.look.mark == Marking::none ? 1 : first.bed.ny(), layout_of(view.look)),
      uncoloured_(colours_water(view.look.colour_by) ? first.bed.nx() : 1,
                  colours_water(view.look.colour_by) ? first.bed.ny() : 1, mark_layout),
      target_layout_(
          repeated(shaded_layout(view.look.ground, shaded_mipmaps_, kind), view.look.ground)),
      target_size_(shaded_size(first_bed.z.nx(), first_bed, samples_across),
                   shaded_size(first_bed.z.ny(), first_bed, samples_across)) {
    target_.emplace(target_size_.x, target_size_.y, target_layout_);
    if (view.look.mode == ViewMode::scenic) draw_noise();
    if (draws_water(view.look, first))
        water_.emplace(view, block, first_bed.z.nx(), first_bed.z.ny(), refinement_);
}

void BedShading::draw_noise() {
    const auto texels = [](double width) {
        return std::max(1, static_cast<int>(noise_texels * width));
    };
    noise_.emplace(texels(block_.width_x), texels(block_.width_y),
                   repeated(noise_layout, view_.look.ground));
    const gl::Program program("common/screen.vert.glsl", "bed/ground_noise.frag.glsl");
    const gl::VertexArray none;
    gl::functions().BindVertexArray(none.name());
    noise_->bind();
    gl::functions().Disable(GL_DEPTH_TEST);
    program.use();
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    const bool endless = view_.look.ground == Ground::endless;
    program.set("periodic", !endless ? 0 : view_.look.grain > 0.0 ? 1 : 2);
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
    if (endless) mipmaps_.make(noise_->colour());
    gl::functions().BindVertexArray(0);
}

/// The values that colours stand for, which set the range of these.
Field<float> BedShading::ranged_values(const Snapshot& snapshot, const Snapshot& first) {
    const bool natural = view_.look.colour_by == Colouring::natural;
    Field<float> values = coloured_values(view_.look.colour_by, snapshot, first);
    range_ = natural ? natural_range(snapshot, block_) : colour_range(view_.look, snapshot, values);
    const Mask without = uncoloured_cells(view_.look.colour_by, snapshot);
    if (!without.empty()) continue_outward(values, without, static_cast<float>(range_.first));
    return values;
}

void BedShading::upload_marks(const Snapshot& snapshot, const DrawnOrigin& origin) {
    const auto upload = [&](gl::Texture2D& texture, const Field<std::uint8_t>& texels) {
        texture.upload(rolled(texels, origin.east, origin.north).data());
    };
    upload(marks_, mark_texels(view_.look.mark, snapshot));
    upload(uncoloured_, uncoloured_texels(view_.look.colour_by, snapshot));
}

void BedShading::upload(const Snapshot& snapshot, const Snapshot& first,
                        const std::vector<std::uint16_t>& lighting, const DisplayWater* water) {
    lighting_.upload(lighting.data());
    const Field<float> values = ranged_values(snapshot, first);
    values_.upload(palette_places(refined(values, refinement_), range_).data());
    upload_marks(snapshot, {});
    if (water_) water_->upload(snapshot, first, *water);
}

void BedShading::upload(const Snapshot& snapshot, const Snapshot& first, const RepeatedLight& light,
                        const DrawnOrigin& origin) {
    noise_origin_ = origin.share;
    // Means over several cells are of what each of them gets.
    lighting_.upload(light.clamped.data());
    mipmaps_.make(lighting_);
    lighting_.upload(light.texels.data());
    constexpr int margin = 2;  // cells that the refinement looks at
    const Field<float> values = ranged_values(snapshot, first);
    floor_places_ = floor_places(values, range_);
    const Field<float> drawn = rolled(values, origin.east, origin.north);
    const Field<float> wide = refined(with_margin(drawn, margin), refinement_);
    values_.upload(palette_places(without_margin(wide, margin * refinement_), range_).data());
    mipmaps_.make(values_);
    upload_marks(snapshot, origin);
}

void BedShading::bind(const gl::Program& program) const {
    lighting_.bind(0);
    values_.bind(1);
    palette_.bind(2);
    marks_.bind(3);
    uncoloured_.bind(4);
    program.set("lighting_map", 0);
    program.set("value_map", 1);
    program.set("palette", 2);
    program.set("mark_map", 3);
    program.set("uncoloured_map", 4);
    if (noise_) {
        noise_->colour().bind(5);
        program.set("noise_map", 5);
        program.set("noise_origin", noise_origin_);
    }
    const bool endless = view_.look.ground == Ground::endless;
    program.set("sun_span", endless ? sun_bounds.highest - sun_bounds.lowest : 1.0F);
    program.set("sun_lowest", endless ? sun_bounds.lowest : 0.0F);
    program.set("shading", static_cast<float>(view_.look.shading));
    program.set("tinted", colours_water(view_.look.colour_by) ? 0.0F : 1.0F);
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program.set("marks", mark_number(view_.look.mark));
    program.set("natural", view_.look.colour_by == Colouring::natural ? 1.0F : 0.0F);
    program.set("rock", static_cast<float>(block_.rock));
    program.set("floor_values", floor_places_);
    set_sand(program, view_.look);
}

/// Of ground under water, which has detail below the grid: as fine as the picture shows it.
void BedShading::size_for(const SeenPart& part) {
    const glm::dvec2 seen = glm::max(part.high - part.low, glm::dvec2(0.0));
    const auto fits = [&](int doubled) {
        const glm::ivec2 size = target_size_ * doubled;
        const double longer = std::max(size.x, size.y);
        return longer <= most_texels_across && longer <= finest_shown * part.sharpness &&
               seen.x * seen.y * size.x * size.y <= most_texels_seen;
    };
    int factor = 1;
    while (fits(2 * factor)) factor *= 2;
    const glm::ivec2 size = target_size_ * factor;
    if (target_->width() == size.x) return;
    target_.reset();
    lighting_.bind(0);  // a new texture takes the unit in use: not the sky's
    target_.emplace(size.x, size.y, target_layout_);
}

void BedShading::shade(const Light& light, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    SeenPart part;
    if (water_) {
        part = seen_part(camera, view_, block_);
        size_for(part);
    }
    target_->bind();
    gl.Disable(GL_DEPTH_TEST);
    program_.use();
    bind(program_);
    set_light(program_, view_, light, camera, block_);
    if (water_) {
        const glm::dvec2 size(target_->width(), target_->height());
        water_->set_uniforms(program_, 6, camera, block_.width_x / size.x);
        const glm::ivec2 low(glm::floor(part.low * size));
        const glm::ivec2 extent = glm::max(glm::ivec2(glm::ceil(part.high * size)) - low, 0);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(low.x, low.y, extent.x, extent.y);
    }
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Disable(GL_SCISSOR_TEST);
    if (shaded_mipmaps_) mipmaps_.make(target_->colour());
}

}  // namespace fumon
