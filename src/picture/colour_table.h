#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.h"

namespace fumon {

/// The colours of many pictures together, counted by the upper 5 bits of each channel.
class ColourCounts {
  public:
    void add(const Image& image);

  private:
    friend class ColourTable;
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(std::size_t{1} << 15U);
};

/// At most 255 colours that stand for all of some pictures (median cut, Heckbert 1982: the box with
/// the largest sum of squares is cut where it lowers that most), and the picture in them. Colours
/// in between are mixed by ordered dithering (Bayer 1973, 8 x 8), which keeps still what stands
/// still.
class ColourTable {
  public:
    explicit ColourTable(const ColourCounts& counts);

    static constexpr int most_colours = 255;  // one is left for what does not change
    /// As 0xFFRRGGBB.
    [[nodiscard]] const std::array<std::uint32_t, 256>& colours() const { return colours_; }
    /// The number of a colour for each pixel, top row first.
    [[nodiscard]] std::vector<std::uint8_t> indices(const Image& image) const;

  private:
    std::array<std::uint32_t, 256> colours_{};
    int count_ = 0;
    double spread_ = 0.0;                ///< usual distance of neighbouring colours, 0 … 255
    std::vector<std::uint8_t> nearest_;  ///< of each 6-bit colour
};

}  // namespace fumon
