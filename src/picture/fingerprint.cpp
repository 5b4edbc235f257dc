#include "picture/fingerprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/image.h"

namespace fumon {

namespace {

/// Sums of a picture's levels over columns × rows boxes of equal size that tile it, in units of a
/// (columns·rows)-th of a pixel, so that they are exact where a box's edge runs through a pixel.
/// All boxes cover `area` of these units: a sum over `area` is the box's mean level.
struct BoxSums {
    std::uint64_t area = 0;
    std::vector<std::uint64_t> sums;  ///< red, green, blue of each box, top row first
};

/// How much of pixel `pixel` lies in box `box`, where `pixels` of them are cut into `boxes`, in
/// units of a boxes-th of a pixel.
std::int64_t overlap(int pixel, int box, int pixels, int boxes) {
    const auto begin = std::max(std::int64_t{pixel} * boxes, std::int64_t{box} * pixels);
    const auto end = std::min((std::int64_t{pixel} + 1) * boxes, (std::int64_t{box} + 1) * pixels);
    return std::max<std::int64_t>(end - begin, 0);
}

int first_pixel(int box, int pixels, int boxes) {
    return static_cast<int>(std::int64_t{box} * pixels / boxes);
}

/// One past the last pixel that reaches into the box.
int end_pixel(int box, int pixels, int boxes) {
    return static_cast<int>(((std::int64_t{box} + 1) * pixels + boxes - 1) / boxes);
}

void add_row(const std::uint8_t* row, std::uint32_t weight, std::vector<std::uint32_t>& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * row[i];
}

/// Boxes may be smaller than pixels. The picture has at least one pixel; what is transparent counts
/// as laid on white.
BoxSums box_sums(const Image& image, int columns, int rows) {
    if (image.transparent()) return box_sums(composited_on(image, 255), columns, rows);
    BoxSums boxes;
    boxes.area = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
    boxes.sums.reserve(std::size_t{3} * static_cast<std::size_t>(columns) *
                       static_cast<std::size_t>(rows));
    std::vector<std::uint32_t> column_sums(std::size_t{3} * static_cast<std::size_t>(image.width));
    for (int box_y = 0; box_y < rows; ++box_y) {
        std::fill(column_sums.begin(), column_sums.end(), 0U);
        const int end_y = end_pixel(box_y, image.height, rows);
        for (int y = first_pixel(box_y, image.height, rows); y < end_y; ++y) {
            add_row(image.row(y), static_cast<std::uint32_t>(overlap(y, box_y, image.height, rows)),
                    column_sums);
        }
        for (int box_x = 0; box_x < columns; ++box_x) {
            std::uint64_t sum[3] = {};
            const int end_x = end_pixel(box_x, image.width, columns);
            for (int x = first_pixel(box_x, image.width, columns); x < end_x; ++x) {
                const auto weight =
                    static_cast<std::uint64_t>(overlap(x, box_x, image.width, columns));
                const std::uint32_t* pixel =
                    &column_sums[std::size_t{3} * static_cast<std::size_t>(x)];
                for (std::size_t channel = 0; channel < 3; ++channel)
                    sum[channel] += weight * pixel[channel];
            }
            boxes.sums.insert(boxes.sums.end(), std::begin(sum), std::end(sum));
        }
    }
    return boxes;
}

}  // namespace

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
