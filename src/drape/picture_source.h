#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "drape/picture_place.h"

namespace fumon {

/// Colours and opacities of pixels, 4 bytes each, the top row first.
struct PixelBlock {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// A rectangle of a picture's pixels.
struct PixelWindow {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

/// A picture file: PNG, JPEG and WebP as they are, all else by GDAL.
class PictureSource {
  public:
    virtual ~PictureSource() = default;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// Where it lies; none where the file does not say.
    [[nodiscard]] const std::optional<PicturePlace>& place() const { return place_; }
    /// The means of squares of `reduction` pixels along each side, from the window's upper left
    /// corner; at its far sides of what is left. What can be seen through counts as much as it
    /// hides.
    [[nodiscard]] virtual PixelBlock reduced(const PixelWindow& window, int reduction) const = 0;

  protected:
    int width_ = 0;
    int height_ = 0;
    std::optional<PicturePlace> place_;
};

/// Opens a picture. `trusted`: files beside it count, and GDAL may read formats that name other
/// files. Throws InputError "FILE: what is wrong; what would be right".
std::unique_ptr<PictureSource> open_picture(const std::filesystem::path& file, bool trusted);

/// An image as a picture that lies nowhere.
std::unique_ptr<PictureSource> picture_of(Image image);

/// Adds up rows of pixels for PictureSource::reduced().
class PixelSums {
  public:
    PixelSums(int width, int reduction);

    void add_row(const std::uint8_t* rgba);
    /// Appends the means of the rows since the last time.
    void finish(std::vector<std::uint8_t>& rgba);
    [[nodiscard]] int width() const { return static_cast<int>(sums_.size() / 5); }

  private:
    int pixels_;
    int reduction_;
    std::vector<std::uint64_t> sums_;  ///< of each: colours times opacity, opacity, pixels
};

}  // namespace fumon
