#include "render/water_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/colour/grain.h"

namespace fumon {

namespace {

constexpr double layers_laid =
    10.0;  // of closed_depth: what hides the ground that was there before
constexpr double least_laid = 0.002;  // m

const gl::TextureLayout map_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
gl::TextureLayout layout_of(const gl::MipmapMaker* mipmaps) {
    gl::TextureLayout layout = map_layout;
    if (mipmaps != nullptr) {
        layout.minification = GL_LINEAR_MIPMAP_NEAREST;
        layout.coarsest = 3;
    }
    return layout;
}

const gl::TextureLayout streak_layout{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR, 0, GL_REPEAT};

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

/// Four numbers a texel.
std::vector<float> interleaved(const std::array<const Field<float>*, 4>& fields) {
    std::vector<float> texels;
    texels.reserve(4 * fields[0]->size());
    for (std::size_t i = 0; i < fields[0]->size(); ++i) {
        for (const Field<float>* field : fields) texels.push_back(field->values()[i]);
    }
    return texels;
}

}  // namespace

WaterShading::WaterShading(const View& view, const Block& block, int nx, int ny, int refinement,
                           const gl::MipmapMaker* mipmaps)
    : view_(view),
      block_(block),
      refinement_(refinement),
      mipmaps_(mipmaps),
      cell_x_(block.width_x / nx),
      cell_y_(block.width_y / ny),
      water_(nx, ny, layout_of(mipmaps)),
      surface_(nx, ny, layout_of(mipmaps)),
      streaks_(grain_size, grain_size, streak_layout, streak_texels().data()) {}

void WaterShading::upload(const Snapshot& snapshot, const Snapshot& first,
                          const DisplayWater& water) {
    const WaterStatistics usual = water_statistics(snapshot);
    clarity_ = water_clarity(view_.look, usual);
    usual_froude_ = usual.median_froude;
    closed_depth_ = closed_depth(snapshot.scale);

    const std::array flow{&water.depth, &water.velocity_x, &water.velocity_y, &water.damp};
    water_.upload(interleaved(flow).data());
    const double rise = block_.height_scale / snapshot.scale.height_unit;
    const auto drawn = static_cast<float>(rise * block_.side);  // slopes, with heights exaggerated
    Field<float> slope_x = water.slope_x;
    Field<float> slope_y = water.slope_y;
    for (float& slope : slope_x.values()) slope *= drawn;
    for (float& slope : slope_y.values()) slope *= drawn;
    const Field<float> fronts = depth_slopes(water.depth, rise / cell_x_, rise / cell_y_);
    const double whole = std::max(layers_laid * closed_depth_, least_laid);
    const Field<float> worked = worked_bed(snapshot, first, whole, refinement_);
    surface_.upload(interleaved({&slope_x, &slope_y, &fronts, &worked}).data());
    if (mipmaps_ != nullptr) {
        mipmaps_->make(water_);
        mipmaps_->make(surface_);
    }
}

void WaterShading::set_uniforms(const gl::Program& program, int unit, const Camera& camera,
                                double texel) const {
    water_.bind(unit);
    surface_.bind(unit + 1);
    streaks_.bind(unit + 2);
    program.set("water_map", unit);
    program.set("surface_map", unit + 1);
    program.set("streak_map", unit + 2);
    program.set("clarity", static_cast<float>(clarity_));
    program.set("turbidity", static_cast<float>(view_.look.turbidity));
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
