#include "render/water_shading.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/colour/grain.h"

namespace fumon {

namespace {

const gl::TextureLayout water_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
const gl::TextureLayout slope_layout{GL_RG32F, GL_RG, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
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

/// The rise of the depth to the east and to the north, two numbers per cell; `scale_x` and
/// `scale_y` turn a difference of depth between neighbours into a slope.
std::vector<float> depth_slopes(const Field<float>& depth, double scale_x, double scale_y) {
    const int nx = depth.nx();
    const int ny = depth.ny();
    const auto factor = [](int low, int high, double scale) {
        return high > low ? static_cast<float>(scale / (high - low)) : 0.0F;
    };
    std::vector<float> slopes;
    slopes.reserve(2 * depth.size());
    for (int y = 0; y < ny; ++y) {
        const int south = std::max(y - 1, 0);
        const int north = std::min(y + 1, ny - 1);
        for (int x = 0; x < nx; ++x) {
            const int west = std::max(x - 1, 0);
            const int east = std::min(x + 1, nx - 1);
            slopes.push_back((depth(east, y) - depth(west, y)) * factor(west, east, scale_x));
            slopes.push_back((depth(x, north) - depth(x, south)) * factor(south, north, scale_y));
        }
    }
    return slopes;
}

}  // namespace

WaterShading::WaterShading(const View& view, const Block& block, int nx, int ny)
    : view_(view),
      block_(block),
      cell_x_(block.width_x / nx),
      cell_y_(block.width_y / ny),
      water_(nx, ny, water_layout),
      slopes_(nx, ny, slope_layout),
      streaks_(grain_size, grain_size, streak_layout, streak_texels().data()) {}

void WaterShading::upload(const Snapshot& snapshot, const DisplayWater& water) {
    std::vector<float> texels;
    texels.reserve(4 * water.depth.size());
    for (std::size_t i = 0; i < water.depth.size(); ++i) {
        for (const Field<float>* field :
             {&water.depth, &water.velocity_x, &water.velocity_y, &water.damp})
            texels.push_back(field->values()[i]);
    }
    water_.upload(texels.data());
    const double rise = block_.height_scale / snapshot.scale.height_unit;
    slopes_.upload(depth_slopes(water.depth, rise / cell_x_, rise / cell_y_).data());
    const WaterStatistics usual = water_statistics(snapshot);
    clarity_ = water_clarity(view_.look, usual);
    usual_froude_ = usual.median_froude;
    closed_depth_ = closed_depth(snapshot.scale);
}

void WaterShading::set_uniforms(const gl::Program& program, int unit) const {
    water_.bind(unit);
    slopes_.bind(unit + 1);
    streaks_.bind(unit + 2);
    program.set("water_map", unit);
    program.set("water_slope_map", unit + 1);
    program.set("streak_map", unit + 2);
    program.set("clarity", static_cast<float>(clarity_));
    program.set("turbidity", static_cast<float>(view_.look.turbidity));
    program.set("usual_froude", static_cast<float>(usual_froude_));
    program.set("closed_depth", static_cast<float>(closed_depth_));
}

}  // namespace fumon
