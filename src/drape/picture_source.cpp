#include "drape/picture_source.h"

#include <algorithm>
#include <string>
#include <utility>

#include "drape/gdal_picture.h"
#include "files/input_file.h"
#include "files/png_reader.h"
#include "picture/stills/jpeg.h"
#include "picture/stills/picture_file.h"
#include "picture/stills/webp.h"

namespace fumon {

namespace {

/// A picture that fumon decodes itself.
class DecodedPicture : public PictureSource {
  public:
    DecodedPicture(Image image, std::optional<PicturePlace> place) : image_(std::move(image)) {
        width_ = image_.width;
        height_ = image_.height;
        place_ = std::move(place);
    }

    [[nodiscard]] PixelBlock reduced(const PixelWindow& window, int reduction) const override {
        PixelSums sums(window.width, reduction);
        PixelBlock block{sums.width(), 0, {}};
        std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(window.width));
        for (int y = 0; y < window.height; ++y) {
            const auto first =
                static_cast<std::size_t>(window.top + y) * static_cast<std::size_t>(image_.width) +
                static_cast<std::size_t>(window.left);
            for (std::size_t x = 0; x < static_cast<std::size_t>(window.width); ++x) {
                std::copy_n(image_.rgb.data() + 3 * (first + x), 3, row.data() + 4 * x);
                row[4 * x + 3] = image_.alpha.empty() ? 255 : image_.alpha[first + x];
            }
            sums.add_row(row.data());
            if ((y + 1) % reduction != 0 && y + 1 != window.height) continue;
            sums.finish(block.rgba);
            ++block.height;
        }
        return block;
    }

  private:
    Image image_;
};

}  // namespace

PixelSums::PixelSums(int width, int reduction)
    : pixels_(width),
      reduction_(reduction),
      sums_(5 * static_cast<std::size_t>((width + reduction - 1) / reduction)) {}

void PixelSums::add_row(const std::uint8_t* rgba) {
    for (int x = 0; x < pixels_; ++x) {
        const std::uint8_t* const pixel = rgba + 4 * static_cast<std::ptrdiff_t>(x);
        std::uint64_t* const sum = sums_.data() + 5 * static_cast<std::ptrdiff_t>(x / reduction_);
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] += static_cast<std::uint64_t>(pixel[channel]) * pixel[3];
        sum[3] += pixel[3];
        sum[4] += 1;
    }
}

void PixelSums::finish(std::vector<std::uint8_t>& rgba) {
    for (std::size_t at = 0; at < sums_.size(); at += 5) {
        const std::uint64_t opacity = sums_[at + 3];
        const std::uint64_t count = std::max<std::uint64_t>(sums_[at + 4], 1);
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgba.push_back(static_cast<std::uint8_t>(
                opacity == 0 ? 0 : (sums_[at + channel] + opacity / 2) / opacity));
        rgba.push_back(static_cast<std::uint8_t>((opacity + count / 2) / count));
    }
    std::ranges::fill(sums_, 0);
}

std::unique_ptr<PictureSource> open_picture(const std::filesystem::path& file, bool trusted) {
    constexpr std::size_t looked_at = 12;  // bytes
    const std::string start = start_of_input_file(file, looked_at);
    if (is_png(start) || is_jpeg(start) || is_webp(start))
        return std::make_unique<DecodedPicture>(read_picture(file),
                                                trusted ? place_beside(file) : std::nullopt);
    return open_gdal_picture(file, trusted);
}

std::unique_ptr<PictureSource> picture_of(Image image) {
    return std::make_unique<DecodedPicture>(std::move(image), std::nullopt);
}

}  // namespace fumon
