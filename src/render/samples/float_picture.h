#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/image.h"
#include "render/colour/pixel_format.h"
#include "render/samples/accumulated_light.h"
#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// Averages samples of a row of pixels, four floats each, over what is behind them; sums run in a
/// fixed order. Display values, 0 … 1, are averaged as their squares, as RowResolver does;
/// radiances as they are. `samples`: `factor` rows one below the other; one is covered where its
/// alpha is not 0. `behind`: the pixels there, or nullptr where there is nothing: the results are
/// then the means over covered samples of display values, and radiances times opacity. `pixels`:
/// four floats each, opacity last.
void resolve_float(const float* samples, int width, int factor, PixelFormat kind,
                   const float* behind, float* pixels);

/// A picture of more than 8 bits, assembled from tiles.
class FloatPicture {
  public:
    /// `open`: with opacities.
    FloatPicture(int width, int height, PixelFormat kind, bool open);

    /// Reads the bound target, of a tile's surroundings.
    void read_background(const Tile& tile);
    /// Reads the bound target of samples, whose first of this tile is `from`.
    void resolve(const Tile& tile, int factor, const glm::ivec2& from, WorkerPool& pool);

    /// Takes a tile's light, of a picture of radiances.
    void put(const AccumulatedLight& light);

    /// The picture of display values, at 16 bits and rounded to 8.
    [[nodiscard]] Image display() const;
    /// The channels R, G, B and, with opacities, A, by which they are multiplied.
    [[nodiscard]] std::vector<ImageLayer> take_channels();

  private:
    int width_;
    int height_;
    PixelFormat kind_;
    bool open_;
    std::vector<std::vector<float>> channels_;
    std::vector<float> behind_;   // RGBA, rows of the last tile, the upper first
    std::vector<float> samples_;  // those of a few rows of pixels
};

}  // namespace fumon
