#include "picture/fingerprint.h"

#include <cmath>

#include "picture/box_average.h"

namespace fumon {

Thumbnail thumbnail_of(const Image& image) {
    const BoxSums boxes = box_sums(image, Thumbnail::width, Thumbnail::height);
    Thumbnail thumbnail;
    for (std::size_t i = 0; i < Thumbnail::count; ++i) {
        thumbnail.levels[i] = static_cast<double>(boxes.sums[i]) / static_cast<double>(boxes.area);
    }
    return thumbnail;
}

Thumbnail in_tenths(const Thumbnail& thumbnail) {
    Thumbnail rounded;
    for (std::size_t i = 0; i < Thumbnail::count; ++i)
        rounded.levels[i] = std::floor(10.0 * thumbnail.levels[i] + 0.5) / 10.0;
    return rounded;
}

std::uint64_t difference_hash(const Image& image) {
    constexpr int columns = 9;
    constexpr int rows = 8;
    const BoxSums boxes = box_sums(image, columns, rows);
    const auto luminance = [&](int x, int y) {
        const int box_number = y * columns + x;
        const std::uint64_t* box =
            &boxes.sums[std::size_t{3} * static_cast<std::size_t>(box_number)];
        return 299 * box[0] + 587 * box[1] + 114 * box[2];  // ITU-R BT.601, in thousandths
    };
    std::uint64_t hash = 0;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x + 1 < columns; ++x)
            hash = (hash << 1U) | static_cast<std::uint64_t>(luminance(x, y) < luminance(x + 1, y));
    }
    return hash;
}

Fingerprint fingerprint_of(const Image& image) {
    return {image.width, image.height, pixel_hash(image), in_tenths(thumbnail_of(image)),
            difference_hash(image)};
}

ThumbnailDifference thumbnail_difference(const Thumbnail& first, const Thumbnail& second) {
    ThumbnailDifference difference;
    for (int y = 0; y < Thumbnail::height; ++y) {
        for (int x = 0; x < Thumbnail::width; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                const double levels = std::abs(first.at(x, y, channel) - second.at(x, y, channel));
                if (levels > difference.largest) difference = {levels, x, y};
            }
        }
    }
    return difference;
}

}  // namespace fumon
