#include "render/bed/bed_shading.h"

#include <algorithm>
#include <cmath>

#include "numerics/resampling.h"
#include "render/bed/natural_colours.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/frame/view_uniforms.h"
#include "render/view/repeated_bed.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

constexpr int invented_unit = 6;     // the water's where a bed on a table has some
constexpr int cover_unit = 17;       // after a drape's
constexpr int enough_texels = 1024;  // along the longer side of the shaded bed, if it is small
// Of ground under water: to a pixel at most so many, along the longer side, and in what is seen.
constexpr double finest_shown = 1.0;
constexpr double finest_shown_of_drape = 2.0;  // whose lettering is to stay as sharp as it is
constexpr double most_texels_across = 4096;
constexpr double most_drape_texels_seen = 8e6;
constexpr double most_texels_seen = 2e6;
constexpr int coarsest_mip_level_read =
    3;  // mipmap: at an edge the samples' places are no neighbours
constexpr int border_texels =
    3 << coarsest_mip_level_read;          // texels that the coarsest one at a border takes in
constexpr double texels_per_sample = 1.3;  // beyond which mipmaps are needed against shimmer

const gl::TextureLayout lighting_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                        GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};
const gl::TextureLayout value_layout{GL_R16,    GL_RED, GL_UNSIGNED_SHORT,
                                     GL_LINEAR, 0,      GL_CLAMP_TO_EDGE};
const gl::TextureLayout mark_layout{GL_R8,      GL_RED, GL_UNSIGNED_BYTE,
                                    GL_NEAREST, 0,      GL_CLAMP_TO_EDGE};
const gl::TextureLayout palette_layout{GL_RGB8,   GL_RGB, GL_UNSIGNED_BYTE,
                                       GL_LINEAR, 0,      GL_CLAMP_TO_EDGE};

/// Of a bed that is repeated, where it is endless; looked at by texels of the target alone.
gl::TextureLayout tiled(gl::TextureLayout layout, Ground ground) {
    if (ground == Ground::endless) layout.wrap = GL_REPEAT;
    return layout;
}

/// The same with mipmaps.
gl::TextureLayout repeated(gl::TextureLayout layout, Ground ground) {
    if (ground == Ground::endless) {
        layout.wrap = GL_REPEAT;
        layout.minification = GL_LINEAR_MIPMAP_LINEAR;
        layout.coarsest_mip_level = gl::TextureLayout{}.coarsest_mip_level;
    }
    return layout;
}

constexpr int coarsest_of_pixels = 3;  // mipmap: beyond it ground is seen too aslant to matter

/// Of a bed that pixels look at from near and far.
gl::TextureLayout lighting_layout_of(Ground ground, bool by_pixels) {
    gl::TextureLayout layout = repeated(lighting_layout, ground);
    if (by_pixels) {
        layout.minification = GL_LINEAR_MIPMAP_NEAREST;
        layout.coarsest_mip_level = coarsest_of_pixels;
    }
    return layout;
}

/// With the sun's share, which is kept within `sun_bounds`, in 0 … 1.
LightTexels with_clamped_sun(LightTexels texels) {
    constexpr float scale = 65535.0F / (sun_bounds.highest - sun_bounds.lowest);
    constexpr auto dark = static_cast<std::uint16_t>(-scale * sun_bounds.lowest + 0.5F);
    constexpr auto lit = static_cast<std::uint16_t>(scale * (1.0F - sun_bounds.lowest) + 0.5F);
    for (std::size_t i = 2; i < texels.size(); i += 4) texels[i] = std::clamp(texels[i], dark, lit);
    return texels;
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
constexpr int most_noise_texels =
    3072;  // the plain round a bed of three cells is twenty sides wide
const gl::TextureLayout noise_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                     GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};
/// Of ground that pixels look at one by one: llvmpipe looks up texels of four bytes in a shorter
/// way.
const gl::TextureLayout coarse_noise_layout{GL_RGBA8,  GL_RGBA, GL_UNSIGNED_BYTE,
                                            GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};

/// The colours of endless ground are lit later: a byte's step of a dark one is two levels of the
/// picture, and falls elsewhere on a bed that is shifted.
gl::TextureLayout shaded_layout(Ground ground, bool mipmaps, PixelFormat kind) {
    gl::TextureLayout layout =
        colour_layout(ground == Ground::endless ? PixelFormat::display_16 : kind);
    if (mipmaps) layout.minification = GL_LINEAR_MIPMAP_LINEAR;
    layout.coarsest_mip_level = coarsest_mip_level_read;
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

/// Where the maps have as many texels as the target they are looked up as they are.
gl::Constants with_own_texels(gl::Constants fixed, const DisplayBed& bed, int samples_across) {
    const bool own = shaded_size(bed.z.nx(), bed, samples_across) == bed.z.nx() &&
                     shaded_size(bed.z.ny(), bed, samples_across) == bed.z.ny();
    fixed.push_back({"own_texels", own ? 1.0F : 0.0F});
    return fixed;
}

const char* shader_of(const LookSettings& look, const Snapshot& first) {
    if (look.ground == Ground::endless) return "bed/shade_albedo.frag.glsl";
    if (look.mode == ViewMode::figure) return "bed/shade_figure.frag.glsl";
    return draws_water(look, first) ? "bed/shade_water.frag.glsl" : "bed/shade_scenic.frag.glsl";
}

const gl::TextureLayout cover_layout{GL_RGBA8,  GL_RGBA, GL_UNSIGNED_BYTE,
                                     GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};

/// 255 in the cells that get no palette place, 1 × 1 where all do.
Field<std::uint8_t> uncoloured_texels(const LookSettings& look, const Snapshot& snapshot,
                                      const Snapshot& first) {
    if (!leaves_cells_uncoloured(look.colour_by)) return {1, 1, 0};
    Field<std::uint8_t> texels = uncoloured_cells(look, snapshot, first);
    if (texels.empty()) return {snapshot.bed.nx(), snapshot.bed.ny(), 0};
    for (std::uint8_t& texel : texels.values()) texel = texel != 0 ? 255 : 0;
    return texels;
}

}  // namespace

BedShading::BedShading(const View& view, const Block& block, const Snapshot& first,
                       const DisplayBed& first_bed, int samples_across, const gl::Constants& fixed,
                       const gl::MipmapMaker& mipmaps, PixelFormat kind,
                       const glm::dvec2& bed_share)
    : view_(view),
      block_(block),
      refinement_(first_bed.z.nx() / first.bed.nx()),
      mipmaps_(mipmaps),
      shaded_mipmaps_(view.look.ground == Ground::endless || view.laid() != nullptr ||
                      longer_shaded_side(first_bed, samples_across) >
                          texels_per_sample * samples_across),
      by_pixels_(shades_water_by_pixel(view, first)),
      program_("common/screen.vert.glsl", shader_of(view.look, first), {},
               with_own_texels(fixed, first_bed, samples_across)),
      palette_(256, 1, palette_layout, chosen_palette(view.look).data()),
      lighting_(first_bed.z.nx(), first_bed.z.ny(),
                lighting_layout_of(view.look.ground, by_pixels_)),
      values_(first_bed.z.nx(), first_bed.z.ny(), tiled(value_layout, view.look.ground)),
      marks_(view.look.mark == Marking::none ? 1 : first.bed.nx(),
             view.look.mark == Marking::none ? 1 : first.bed.ny(), layout_of(view.look)),
      uncoloured_(leaves_cells_uncoloured(view.look.colour_by) ? first.bed.nx() : 1,
                  leaves_cells_uncoloured(view.look.colour_by) ? first.bed.ny() : 1, mark_layout),
      target_layout_(
          repeated(shaded_layout(view.look.ground, shaded_mipmaps_, kind), view.look.ground)),
      target_size_(shaded_size(first_bed.z.nx(), first_bed, samples_across),
                   shaded_size(first_bed.z.ny(), first_bed, samples_across)) {
    if (!by_pixels_) target_.emplace(target_size_.x, target_size_.y, target_layout_);
    if (view.look.mode == ViewMode::scenic) draw_noise();
    if (draws_water(view.look, first))
        water_.emplace(view, block, first_bed.z.nx() / block.tiles.count(), first_bed.z.ny(),
                       refinement_,
                       by_pixels_ || view.look.ground == Ground::endless ? &mipmaps : nullptr);
    if (const Drape* laid = view.laid(); laid != nullptr)
        drape_.emplace(*laid, view.look, bed_share);
}

void BedShading::draw_noise() {
    const auto texels = [](double width) {
        return std::clamp(static_cast<int>(noise_texels * width), 1, most_noise_texels);
    };
    noise_.emplace(texels(block_.width_x), texels(block_.width_y),
                   tiled(by_pixels_ ? coarse_noise_layout : noise_layout, view_.look.ground));
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
    gl::functions().BindVertexArray(0);
}

/// The values that colours stand for, which set the range of these.
Field<float> BedShading::ranged_values(const Snapshot& snapshot, const Snapshot& first) {
    const bool natural = view_.look.colour_by == Colouring::natural;
    Field<float> values = coloured_values(view_.look, snapshot, first);
    if (natural) {
        const auto [low, high] = natural_range(snapshot, block_);
        range_ = {low, high};
        bare_board_ = bare_board(snapshot, view_.look, {low, high});
    } else {
        range_ = frame_colour_range(view_.look, snapshot, values, range_, keeps_range_);
    }
    const Mask without = uncoloured_cells(view_.look, snapshot, first);
    if (!without.empty()) extrapolate_outward(values, without, static_cast<float>(range_.low));
    return values;
}

void BedShading::upload_marks(const Snapshot& snapshot, const Snapshot& first,
                              const DrawnOrigin& origin) {
    const auto upload = [&](gl::Texture2D& texture, const Field<std::uint8_t>& texels) {
        texture.upload(rolled(texels, origin.east, origin.north).data());
    };
    upload(marks_, mark_texels(view_.look.mark, snapshot));
    upload(uncoloured_, uncoloured_texels(view_.look, snapshot, first));
}

void BedShading::upload(const Snapshot& snapshot, const Snapshot& first,
                        const LightTexels& lighting, const DisplayWater* water) {
    if (by_pixels_) {
        // Means over several cells are of what each of them gets.
        lighting_.upload(with_clamped_sun(lighting).data());
        mipmaps_.make(lighting_);
    }
    lighting_.upload(lighting.data());
    const Field<float> values = ranged_values(snapshot, first);
    const Field<std::uint16_t> positions =
        palette_coordinates(refined(values, refinement_), {range_.low, range_.high});
    values_.upload(positions.data());
    upload_marks(snapshot, first, {});
    if (water_) water_->upload(snapshot, first, *water, positions);
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
    floor_coordinates_ = floor_coordinates(values, {range_.low, range_.high});
    const Field<float> drawn = rolled(values, origin.east, origin.north);
    const Field<float> wide = refined(with_margin(drawn, margin), refinement_);
    values_.upload(
        palette_coordinates(without_margin(wide, margin * refinement_), {range_.low, range_.high})
            .data());
    upload_marks(snapshot, first, origin);
}

void BedShading::upload_water(const Snapshot& snapshot, const Snapshot& first,
                              const DisplayWater& water) {
    const Field<float> values(water.depth.nx(), water.depth.ny());
    water_->upload(snapshot, first, water, palette_coordinates(values, {0.0, 1.0}));
}

void BedShading::bind_water(const gl::Program& program, const std::array<int, 5>& units,
                            const Camera& camera) const {
    if (water_) water_->set_uniforms(program, units, camera, 0.0);
}

void BedShading::pale(const Field<std::uint8_t>& invented) {
    gl::TextureLayout layout = mark_layout;
    layout.filter = GL_LINEAR;
    layout.wrap = GL_REPEAT;
    invented_.emplace(invented.nx(), invented.ny(), layout, invented.data());
}

void BedShading::cover(const Field<CellCover>& cells) {
    cover_.emplace(cells.nx(), cells.ny(), tiled(cover_layout, view_.look.ground), cells.data());
}

void BedShading::bind(const gl::Program& program, const glm::dvec2& texel) const {
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
    if (cover_) {
        cover_->bind(cover_unit);
        program.set("cover_map", cover_unit);
    }
    program.set("pales", invented_ ? 1.0F : 0.0F);
    if (invented_) {
        invented_->bind(invented_unit);
        program.set("invented_map", invented_unit);
    }
    if (noise_) {
        noise_->colour().bind(5);
        program.set("noise_map", 5);
        program.set("noise_origin", noise_origin_);
    }
    const bool wide = view_.look.ground == Ground::endless || water_;
    program.set("sun_span", wide ? sun_bounds.highest - sun_bounds.lowest : 1.0F);
    program.set("sun_lowest", wide ? sun_bounds.lowest : 0.0F);
    program.set("shading", static_cast<float>(view_.look.shading));
    program.set("tinted", colours_water(view_.look.colour_by) ? 0.0F : 1.0F);
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program.set("marks", mark_number(view_.look.mark));
    program.set("paved", view_.look.rock == RockSurface::pavement ? 1.0F : 0.0F);
    program.set("natural", view_.look.colour_by == Colouring::natural ? 1.0F : 0.0F);
    program.set("rock", static_cast<float>(block_.rock));
    program.set("floor_values", floor_coordinates_);
    program.set("bare_board", bare_board_);
    set_sand(program, view_.look);
    if (drape_) drape_->bind(program, texel, noise_origin_);
}

void BedShading::bind_all(const gl::Program& program, const Light& light, const Camera& camera,
                          double texel) const {
    bind(program, texel / glm::dvec2(block_.width_x, block_.width_y));
    set_light(program, view_, light, camera, block_);
    if (water_) water_->set_uniforms(program, {6, 7, 8, 9, 10}, camera, texel);
}

bool BedShading::sized_by_view() const {
    return (water_ || drape_) && view_.look.ground != Ground::endless;
}

/// Of ground under water or a drape, which have detail below the grid: as fine as the picture shows
/// it, of a drape alone as fine as that is.
void BedShading::size_for(const VisiblePart& part) {
    const glm::dvec2 seen = glm::max(part.high - part.low, glm::dvec2(0.0));
    const double finest = drape_ ? finest_shown_of_drape : finest_shown;
    const double most_seen = drape_ ? most_drape_texels_seen : most_texels_seen;
    const glm::ivec2 own = drape_ && !water_ ? 4 * drape_->size() : glm::ivec2(0);
    const auto fits = [&](int doubled) {
        const glm::ivec2 size = target_size_ * doubled;
        const double longer = std::max(size.x, size.y);
        const bool finer = drape_ && !water_ && size.x >= own.x && size.y >= own.y;
        return longer <= most_texels_across && longer <= finest * part.sharpness && !finer &&
               seen.x * seen.y * size.x * size.y <= most_seen;
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
    if (by_pixels_) {
        lighting_.bind(0);  // new textures take the unit in use: not the sky's
        return;
    }
    const gl::Functions& gl = gl::functions();
    VisiblePart part;
    if (sized_by_view()) {
        part = visible_part(camera, view_, block_);
        size_for(part);
    }
    target_->bind();
    gl.Disable(GL_DEPTH_TEST);
    program_.use();
    bind_all(program_, light, camera, block_.width_x / target_->width());
    if (sized_by_view()) {
        const glm::dvec2 size(target_->width(), target_->height());
        const glm::ivec2 low = glm::ivec2(glm::floor(part.low * size)) - border_texels;
        const glm::ivec2 high = glm::ivec2(glm::ceil(part.high * size)) + border_texels;
        const glm::ivec2 extent = glm::max(high - low, 0);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(low.x, low.y, extent.x, extent.y);
    }
    // Texels of the target are no larger than those of the maps, of which no means are looked at.
    if (view_.look.ground == Ground::endless) lighting_.bind_mip_level(0, 0);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    if (view_.look.ground == Ground::endless) lighting_.bind_all_mip_levels(0);
    gl.Disable(GL_SCISSOR_TEST);
    if (shaded_mipmaps_) mipmaps_.make(target_->colour());
}

void BedShading::read(BlockTexture& colours) const {
    colours.width = target_->width();
    colours.height = target_->height();
    colours.texels.resize(static_cast<std::size_t>(colours.width) *
                          static_cast<std::size_t>(colours.height));
    target_->bind();
    gl::functions().ReadPixels(0, 0, colours.width, colours.height, GL_RGBA, GL_UNSIGNED_BYTE,
                               colours.texels.data());
}

}  // namespace fumon
