#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "gl/texture.h"
#include "render/samples/pixel_classes.h"
#include "render/view/tiles.h"

namespace fumon {

/// Samples of those pixels of endless ground that see several things: edges of what is
/// seen. Few pixels are, so their samples are coloured side by side in a small target, and not
/// where they lie among all the others.
class PackedSamples {
  public:
    /// `factor`: samples along each side of a pixel.
    explicit PackedSamples(int factor);

    /// Reads the bound target as WorldLayer::shade_pixels() left it, whose first pixel has the
    /// sample `first` at its lower left.
    void read_pixels(const Tile& tile, const glm::ivec2& first, const PixelClasses& kinds);

    /// Which ground is coloured.
    enum class Ground { near, far };
    /// Colours the samples of that ground: `draw` does it in the bound target, for listed pixels
    /// whose first samples the texture holds, a texel each.
    void colour(Ground ground, const std::function<void(const gl::Texture2D& listed)>& draw);

    /// The samples of a row of pixels (the lowest is 0), `factor` rows of them from the lowest on;
    /// 0 where no ground is seen, else alpha, in the highest byte, is 255.
    void write_row(int y, std::uint32_t* samples) const;

  private:
    /// Of one ground: pixels in the order of their rows, and factor² samples of each.
    struct EdgePixels {
        std::vector<std::uint32_t> pixels;  // y · width + x
        std::vector<std::uint32_t> samples;
    };

    int factor_;
    int width_ = 0;
    glm::ivec2 first_{0};
    std::vector<std::uint32_t> pixels_;  // colours of single-surface pixels, rows upward; 0: others
    std::array<EdgePixels, 2> edges_;
    gl::Texture2D listed_;
    gl::RenderTarget target_;
    std::vector<glm::vec2> first_samples_;    // as listed
    std::vector<std::uint32_t> packed_read_;  // as the target has them
};

}  // namespace fumon
