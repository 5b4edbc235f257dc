#include "render/lens/lens_tone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gl/functions.h"
#include "render/frame/view_uniforms.h"

namespace fumon {

namespace {

constexpr int toned_pixels_per_band = 1 << 18;  // pixels: 4 MiB of floats

const gl::TextureLayout accumulated_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT,
                                           GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};

/// Through rows of 16 bits either way: a byte's step is then 257 of theirs.
gl::TextureLayout shown_layout(bool deep) {
    gl::TextureLayout layout =
        colour_layout(deep ? PixelFormat::display_16 : PixelFormat::display_8);
    layout.filter = GL_NEAREST;
    return layout;
}

}  // namespace

LensTone::LensTone(const Tile& largest, const gl::Constants& fixed, bool deep)
    : rows_(std::clamp(toned_pixels_per_band / largest.width, 1, largest.height)),
      program_("common/screen.vert.glsl", "lens/accumulated.frag.glsl", {}, fixed),
      accumulated_(largest.width, rows_, accumulated_layout),
      shown_(largest.width, rows_, shown_layout(deep)) {}

void LensTone::put(const AccumulatedLight& light, const View& view, const Light& of,
                   const Camera& camera, const Block& block, Image& image) const {
    const gl::Functions& gl = gl::functions();
    const Tile& tile = light.tile();
    const bool deep = !image.rgb16.empty();
    const auto across = static_cast<std::size_t>(accumulated_.width());
    const std::size_t width = 4 * static_cast<std::size_t>(tile.width);
    std::vector<float> given(4 * across * static_cast<std::size_t>(rows_));
    std::vector<std::uint16_t> levels(width * static_cast<std::size_t>(rows_));
    for (int upper = 0; upper < tile.height; upper += rows_) {
        const int rows = std::min(rows_, tile.height - upper);
        for (int y = 0; y < rows; ++y)
            std::copy_n(light.row(upper + y), width,
                        given.data() + 4 * across * static_cast<std::size_t>(y));
        accumulated_.upload(given.data());
        shown_.bind();
        gl.Disable(GL_DEPTH_TEST);
        program_.use();
        set_light(program_, view, of, camera, block);
        accumulated_.bind(0);
        program_.set("accumulated", 0);
        program_.set("first_pixel", glm::vec2(glm::ivec2(tile.x, tile.y + upper)));
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        gl.ReadPixels(0, 0, tile.width, rows, GL_RGBA, GL_UNSIGNED_SHORT, levels.data());
        for (int y = 0; y < rows; ++y) {
            const float* opacity = light.row(upper + y) + 3;
            const std::uint16_t* level = levels.data() + width * static_cast<std::size_t>(y);
            std::size_t at = static_cast<std::size_t>(tile.y + upper + y) *
                                 static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(tile.x);
            for (int x = 0; x < tile.width; ++x, ++at, level += 4, opacity += 4) {
                for (std::size_t c = 0; c < 3; ++c) {
                    if (deep) image.rgb16[3 * at + c] = level[c];
                    image.rgb[3 * at + c] = rounded_to_8(level[c]);
                }
                if (image.transparent())
                    image.alpha[at] = static_cast<std::uint8_t>(
                        std::lround(255.0 * static_cast<double>(*opacity)));
            }
        }
    }
}

}  // namespace fumon
