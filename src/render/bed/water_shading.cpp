#include "render/bed/water_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/rounding.h"
#include "numerics/smooth_step.h"
#include "render/colour/grain.h"
#include "render/rain/drop_rings.h"

namespace fumon {

namespace {

constexpr double layers_laid =
    10.0;  // of closed_depth: what hides the ground that was there before
constexpr double least_laid = 0.002;  // m

const gl::TextureLayout map_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
// llvmpipe looks up texels of four bytes in a shorter way.
const gl::TextureLayout wet_ground_layout{GL_RGBA8,  GL_RGBA, GL_UNSIGNED_BYTE,
                                          GL_LINEAR, 0,       GL_CLAMP_TO_EDGE};

/// `repeats`: over ground that repeats to the horizon.
gl::TextureLayout with_mipmaps(gl::TextureLayout layout, const gl::MipmapMaker* mipmaps,
                               bool repeats) {
    if (repeats) layout.wrap = GL_REPEAT;
    if (mipmaps != nullptr) {
        layout.minification = GL_LINEAR_MIPMAP_NEAREST;
        layout.coarsest_mip_level = 3;
    }
    return layout;
}

const gl::TextureLayout streak_layout{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR, 0, GL_REPEAT};

const gl::TextureLayout ring_layout{
    GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_REPEAT};

bool repeats(const View& view, const Block& block) {
    return view.look.ground == Ground::endless && !block.tiles.plain;
}

constexpr int ring_unit = 14;  // sand that blows has it elsewhere

/// A seamless square of noise for streaks and ripples, four bytes a texel: the noise, its
/// differences to the next texels east and north, halved around 128, and 255.
std::vector<std::uint8_t> streak_texels() {
    const std::vector<std::uint8_t> noise = grain_texels();
    constexpr auto size = static_cast<std::size_t>(grain_size);
    const auto at = [&](std::size_t x, std::size_t y) {
        return int{noise[(y % size) * size + x % size]};
    };
    const auto slope = [](int from, int to) {
        return static_cast<std::uint8_t>(128 + (to - from) / 2);
    };
    std::vector<std::uint8_t> texels;
    texels.reserve(4 * noise.size());
    for (std::size_t y = 0; y < size; ++y) {
        for (std::size_t x = 0; x < size; ++x) {
            const int here = at(x, y);
            texels.insert(texels.end(), {static_cast<std::uint8_t>(here), slope(here, at(x + 1, y)),
                                         slope(here, at(x, y + 1)), std::uint8_t{255}});
        }
    }
    return texels;
}

constexpr int wide_rills = 180;  // texels of streaks to the side of rills: 1.7 cells to 0.6
// Shares of the wider ones.
constexpr double wide_height = 0.30 / 0.45;
constexpr double wide_slope = 0.50 / 0.90;

/// A seamless square of noise for rills, whose texels are as wide as those of `streaks`: a mix of
/// these, turned, and of wider ones, as shaders/bed/soil.glsl weighs them; its height and its
/// slopes east and north, around ½.
std::vector<std::uint8_t> rill_texels(const std::vector<std::uint8_t>& streaks) {
    constexpr auto size = static_cast<std::size_t>(grain_size);
    const auto streak = [&](int x, int y, std::size_t channel) {
        const std::size_t at = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
        return static_cast<double>(streaks[4 * at + channel]) / 127.5 - 1.0;
    };
    // White noise is as seamless in a part of the square.
    const auto wide = [&](int x, int y, std::size_t channel) {
        const double east = static_cast<double>(x) * wide_rills / grain_size;
        const double north = static_cast<double>(y) * wide_rills / grain_size;
        const int left = static_cast<int>(east);
        const int low = static_cast<int>(north);
        const auto row = [&](int at) {
            const int right = (left + 1) % wide_rills;
            return std::lerp(streak(left, at, channel), streak(right, at, channel), east - left);
        };
        return std::lerp(row(low), row((low + 1) % wide_rills), north - low);
    };
    const auto byte = [](double value) {
        return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * value));
    };
    std::vector<std::uint8_t> texels;
    texels.reserve(streaks.size());
    for (int y = 0; y < grain_size; ++y) {
        for (int x = 0; x < grain_size; ++x) {
            const auto mixed = [&](double of_wide, std::size_t channel, std::size_t turned) {
                return byte(of_wide * wide(x, y, channel) + (1.0 - of_wide) * streak(y, x, turned));
            };
            texels.insert(texels.end(), {mixed(wide_height, 0, 0), mixed(wide_slope, 1, 2),
                                         mixed(wide_slope, 2, 1), std::uint8_t{255}});
        }
    }
    return texels;
}

/// How steeply the depth changes, in block lengths: `scale_x` and `scale_y` turn a difference of
/// depth between neighbours into a slope.
Field<float> depth_slopes(const Field<float>& depth, double scale_x, double scale_y) {
    const int nx = depth.nx();
    const int ny = depth.ny();
    const auto factor = [](int low, int high, double scale) {
        return high > low ? static_cast<float>(scale / (high - low)) : 0.0F;
    };
    Field<float> slopes(nx, ny);
    for (int y = 0; y < ny; ++y) {
        const int south = std::max(y - 1, 0);
        const int north = std::min(y + 1, ny - 1);
        for (int x = 0; x < nx; ++x) {
            const int west = std::max(x - 1, 0);
            const int east = std::min(x + 1, nx - 1);
            const float along = (depth(east, y) - depth(west, y)) * factor(west, east, scale_x);
            const float across =
                (depth(x, north) - depth(x, south)) * factor(south, north, scale_y);
            slopes(x, y) = std::sqrt(along * along + across * across);
        }
    }
    return slopes;
}

std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(nearest(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

/// How far water covers a cell, 0 … 1: as shaders/bed/water.glsl closes it over even ground.
float cover_by(float depth, double clarity, double closed) {
    return static_cast<float>(smooth_step(0.004, 0.06, depth / clarity) *
                              smooth_step(0.5, 1.7, depth / closed));
}

/// How damp ground is, what was laid down on it, its value and how far water covers it.
Field<std::uint8_t> wet_ground_texels(const DisplayWater& water, const Field<float>& worked,
                                      const Field<std::uint16_t>& values, double clarity,
                                      double closed) {
    Field<std::uint8_t> texels(4 * values.nx(), values.ny());
    std::uint8_t* texel = texels.data();
    for (std::size_t i = 0; i < values.size(); ++i, texel += 4) {
        texel[0] = byte_of(water.damp.values()[i]);
        texel[1] = byte_of(0.5F + 0.5F * worked.values()[i]);
        texel[2] = byte_of(static_cast<float>(values.values()[i]) / 65535.0F);
        texel[3] = byte_of(cover_by(water.depth.values()[i], clarity, closed));
    }
    return texels;
}

/// How turbid the water is by place; empty where it is so everywhere.
Field<float> turbidity_texels(const DisplayWater& water, double clearest) {
    Field<float> turbidity = water.silt;
    for (float& silt : turbidity.values())
        silt = std::lerp(static_cast<float>(clearest), 1.0F, std::clamp(silt, 0.0F, 1.0F));
    return turbidity;
}

/// Three numbers a texel, and one more or, where there is none, `otherwise`.
Field<float> interleaved(const std::array<const Field<float>*, 3>& fields, const Field<float>& more,
                         float otherwise) {
    Field<float> texels(4 * fields[0]->nx(), fields[0]->ny());
    const std::array<const float*, 3> from{fields[0]->data(), fields[1]->data(), fields[2]->data()};
    float* texel = texels.data();
    for (std::size_t i = 0; i < fields[0]->size(); ++i, texel += 4) {
        texel[0] = from[0][i];
        texel[1] = from[1][i];
        texel[2] = from[2][i];
        texel[3] = more.empty() ? otherwise : more.values()[i];
    }
    return texels;
}

}  // namespace

bool shades_water_by_pixel(const View& view, const Snapshot& first) {
    return draws_water(view.look, first) && view.look.ground != Ground::endless &&
           !view.camera.has_lens() && view.camera.projection != Projection::map;
}

WaterShading::WaterShading(const View& view, const Block& block, int nx, int ny, int refinement,
                           const gl::MipmapMaker* mipmaps)
    : view_(view),
      block_(block),
      refinement_(refinement),
      mipmaps_(mipmaps),
      cell_x_(block.width_x / nx),
      cell_y_(block.width_y / ny),
      ground_(nx, ny, with_mipmaps(wet_ground_layout, mipmaps, repeats(view, block))),
      water_(nx, ny, with_mipmaps(map_layout, mipmaps, repeats(view, block))),
      surface_(nx, ny, with_mipmaps(map_layout, mipmaps, repeats(view, block))),
      streaks_(grain_size, grain_size, streak_layout, streak_texels().data()),
      rills_(grain_size, grain_size, streak_layout, rill_texels(streak_texels()).data()),
      rings_(ring_texels, ring_texels, ring_layout) {
    rings_.allocate_mipmaps();
}

void WaterShading::upload(const Snapshot& snapshot, const Snapshot& first,
                          const DisplayWater& water, const Field<std::uint16_t>& values) {
    const WaterStatistics usual = water_statistics(snapshot);
    clarity_ = water_clarity(view_.look, usual);
    turbidity_ = mean_turbidity(view_.look, snapshot);
    usual_froude_ = usual.median_froude;
    closed_depth_ = closed_depth(snapshot.scale);

    water_.upload(interleaved({&water.depth, &water.velocity_x, &water.velocity_y},
                              turbidity_texels(water, view_.look.turbidity),
                              static_cast<float>(view_.look.turbidity))
                      .data());
    const double rise = block_.height_scale / snapshot.scale.height_unit;
    const auto drawn = static_cast<float>(rise * block_.side);  // slopes, with heights exaggerated
    Field<float> slope_x = water.slope_x;
    Field<float> slope_y = water.slope_y;
    for (float& slope : slope_x.values()) slope *= drawn;
    for (float& slope : slope_y.values()) slope *= drawn;
    Field<float> standing = water.depth;
    for (float& metres : standing.values()) metres = std::max(metres, 0.0F);
    const Field<float> fronts = depth_slopes(standing, rise / cell_x_, rise / cell_y_);
    const double whole = std::max(layers_laid * closed_depth_, least_laid);
    const Field<float> worked = worked_bed(snapshot, first, whole, refinement_);
    surface_.upload(interleaved({&slope_x, &slope_y, &fronts}, water.ringed, 1.0F).data());
    ground_.upload(wet_ground_texels(water, worked, values, clarity_, closed_depth_).data());
    rains_ = !water.rings.empty();
    ring_mean_ = rains_ ? static_cast<float>(water.rings.back()[2]) / 255.0F : 0.0F;
    for (std::size_t level = 0; level < water.rings.size(); ++level)
        rings_.set_mipmap(static_cast<int>(level), water.rings[level].data());
    if (mipmaps_ != nullptr) {
        mipmaps_->make(ground_);
        mipmaps_->make(water_);
        mipmaps_->make(surface_);
    }
}

void WaterShading::set_uniforms(const gl::Program& program, const std::array<int, 5>& units,
                                const Camera& camera, double texel) const {
    water_.bind(units[0]);
    surface_.bind(units[1]);
    streaks_.bind(units[2]);
    ground_.bind(units[3]);
    rills_.bind(units[4]);
    rings_.bind(ring_unit);
    program.set("water_map", units[0]);
    program.set("water_surface_map", units[1]);
    program.set("streak_map", units[2]);
    program.set("ground_map", units[3]);
    program.set("rill_map", units[4]);
    program.set("ring_map", ring_unit);
    program.set("ring_layers", rains_ ? ring_layers : 0);
    program.set("ring_tile_m", static_cast<float>(ring_tile_m / block_.side));
    program.set("ring_ends", glm::vec2(max_ring_slope, max_ring_mean_square_slope));
    program.set("ring_mean", ring_mean_);
    program.set("clarity", static_cast<float>(clarity_));
    program.set("usual_froude", static_cast<float>(usual_froude_));
    program.set("closed_depth", static_cast<float>(closed_depth_));
    program.set("metre", static_cast<float>(1.0 / block_.side));
    program.set("steepening", static_cast<float>(block_.exaggeration));
    program.set("cell", static_cast<float>(refinement_ * std::max(cell_x_, cell_y_)));
    program.set("texel", static_cast<float>(texel));
    program.set("pixel_width",
                static_cast<float>(2.0 * camera.half.y / static_cast<double>(view_.image.height)));
}

}  // namespace fumon
