#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace fumon {

namespace samples {

/// Planes of a row's sums, one number a sample.
struct Sums {
    std::uint32_t* red;
    std::uint32_t* green;
    std::uint32_t* blue;
    std::uint32_t* covered;
};

}  // namespace samples

/// Colours for pixels of alpha 0, whose own nobody sees: those of the nearest pixel of their row
/// that is covered, or of the nearest row with one. So no dark fringe comes out where programs
/// average colours without regard to alpha, or encode them.
void dilate_colours(Image& image);

/// A row of colours, a plane for each channel, 0 … 255.
struct ColourPlanes {
    explicit ColourPlanes(int width);

    std::vector<std::uint8_t> red;  ///< as long as vectors need it
    std::vector<std::uint8_t> green;
    std::vector<std::uint8_t> blue;
};

/// A row of pixels as RGB.
void write_row(const ColourPlanes& planes, int width, std::uint8_t* rgb);

/// Averages the samples of a row of pixels in (nearly) linear light, as squares of display values,
/// over what is behind them:
///     pixel = √( (Σ sample² + behind²·(n − covered)) / n ), to the nearest whole number.
/// In whole numbers but for the root, so the same on every processor.
class RowResolver {
  public:
    /// `factor`: samples along each side of a pixel, 1, 2 or 4.
    RowResolver(int width, int factor);

    /// A row of factor·width samples, red in the lowest byte: 0 where nothing covers one, else
    /// alpha, in the highest, is 255. Reads up to `samples_read_beyond` of them past its end.
    void add(const std::uint32_t* row);
    /// Writes the pixels as RGB, and starts anew. Wants `factor` rows to have been added.
    void finish(const ColourPlanes& behind, std::uint8_t* rgb);
    /// The same where nothing is behind: colours of what covers the pixels alone (√(Σ sample² /
    /// covered), 0 where nothing does), and which share of each is covered, of 255.
    void finish_transparent(std::uint8_t* rgb, std::uint8_t* alpha);

    static constexpr int samples_read_beyond = 16;

  private:
    void sum_up();
    void reset();

    int width_;
    int factor_;
    std::vector<std::uint32_t> red_;  ///< sums of squares, of each sample of the row
    std::vector<std::uint32_t> green_;
    std::vector<std::uint32_t> blue_;
    std::vector<std::uint32_t> covered_;  ///< how many samples are
    ColourPlanes pixels_;
};

}  // namespace fumon
