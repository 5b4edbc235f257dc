#include "film/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "film/cache/frame_spool.h"
#include "film/panes.h"

namespace fumon {

namespace {

constexpr int widest_tile_pixels = 480;  // pixels
constexpr int most_column_count = 5;
constexpr int tile_gap_pixels = 4;  // pixels

}  // namespace

ContactSheet::ContactSheet(std::int64_t frames, double rate, int width, int height)
    : width_(std::min(width, widest_tile_pixels)),
      height_(std::max(
          1, static_cast<int>(std::lround(static_cast<double>(width_) * height / width)))) {
    const auto second = static_cast<std::int64_t>(std::max(1.0, rate));
    for (std::int64_t frame = 0; frame < frames; frame += second) frames_.push_back(frame);
    if (frames_.back() != frames - 1) frames_.push_back(frames - 1);
    const auto count = static_cast<int>(frames_.size());
    columns_ = std::min(most_column_count, count);
    const int rows = (count + columns_ - 1) / columns_;
    image_ = Image(columns_ * (width_ + tile_gap_pixels) - tile_gap_pixels,
                   rows * (height_ + tile_gap_pixels) - tile_gap_pixels);
}

bool ContactSheet::shows(std::int64_t frame) const {
    return std::ranges::binary_search(frames_, frame);
}

void ContactSheet::add(std::int64_t frame, const Image& image) {
    const auto place = static_cast<int>(std::ranges::lower_bound(frames_, frame) - frames_.begin());
    copy_into(image_, resized(image, width_, height_),
              {place % columns_ * (width_ + tile_gap_pixels),
               place / columns_ * (height_ + tile_gap_pixels), width_, height_});
}

}  // namespace fumon
