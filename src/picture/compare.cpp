#include "picture/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/error.h"

namespace fumon {

namespace {

void check_sizes(const Image& first, const Image& second) {
    if (first.width != second.width || first.height != second.height) {
        throw InputError(fmt::format("pictures of {} × {} and {} × {} pixels cannot be compared",
                                     first.width, first.height, second.width, second.height));
    }
    if (first.width < 1 || first.height < 1)
        throw InputError("pictures without pixels cannot be compared");
}

int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// What the levels of one row of `pixels` differ by.
struct RowDifference {
    int largest = 0;
    int changed = 0;
    std::int64_t sum = 0;
};

RowDifference row_difference(const std::uint8_t* a, const std::uint8_t* b, int pixels) {
    RowDifference row;
    if (std::equal(a, a + std::ptrdiff_t{3} * pixels, b)) return row;
    for (int x = 0; x < pixels; ++x, a += 3, b += 3) {
        const int red = std::abs(a[0] - b[0]);
        const int green = std::abs(a[1] - b[1]);
        const int blue = std::abs(a[2] - b[2]);
        row.largest = std::max({row.largest, red, green, blue});
        row.changed += static_cast<int>((red | green | blue) != 0);
        row.sum += red + green + blue;
    }
    return row;
}

}  // namespace

Comparison compare(const Image& first, const Image& second) {
    check_sizes(first, second);
    if (first.transparent() || second.transparent()) {
        const Comparison dark = compare(laid_on(first, 0), laid_on(second, 0));
        const Comparison pale = compare(laid_on(first, 255), laid_on(second, 255));
        return dark.mean > pale.mean ? dark : pale;
    }
    Comparison comparison;
    std::int64_t sum = 0;
    for (int y = 0; y < first.height; ++y) {
        const RowDifference row = row_difference(first.row(y), second.row(y), first.width);
        comparison.largest = std::max(comparison.largest, row.largest);
        comparison.changed += row.changed;
        sum += row.sum;
    }
    const double pixels = static_cast<double>(first.width) * static_cast<double>(first.height);
    comparison.changed_share = static_cast<double>(comparison.changed) / pixels;
    comparison.mean = static_cast<double>(sum) / (3.0 * pixels);
    if (comparison.changed == 0) return comparison;
    comparison.tiles = tile_similarity(first, second);
    comparison.thumbnail = thumbnail_difference(thumbnail_of(first), thumbnail_of(second));
    return comparison;
}

std::string_view name_of(Likeness likeness) {
    constexpr std::array<std::string_view, 4> names{"different", "close", "same to the eye",
                                                    "identical"};
    return names[static_cast<std::size_t>(likeness)];
}

Likeness likeness(const Comparison& comparison) {
    const auto within = [&](const LikenessLimits& limits) {
        return comparison.thumbnail.largest <= limits.thumbnail &&
               comparison.tiles.smallest >= limits.tile_ssim;
    };
    if (comparison.changed == 0) return Likeness::identical;
    if (within(same_to_the_eye_limits)) return Likeness::same_to_the_eye;
    return within(close_limits) ? Likeness::close : Likeness::different;
}

std::string likeness_help() {
    return fmt::format(
        "identical        every pixel is the same\n"
        "same to the eye  thumbnails within {} grey levels and every 8 x 8 tile's SSIM at least "
        "{},\n"
        "                 as on another processor (0.001, 0.999), the sun 0.1 degrees on (0.4, "
        "0.997)\n"
        "close            within {} and at least {}, as one sample a pixel for four (0.3, 0.50),\n"
        "                 young dunes a step later (0.9, 0.62)\n"
        "different        all else, as the sun 1 degree on (4.5, 0.92), dunes moved by 2 % of a\n"
        "                 wavelength (6.9, -0.38)\n",
        same_to_the_eye_limits.thumbnail, same_to_the_eye_limits.tile_ssim, close_limits.thumbnail,
        close_limits.tile_ssim);
}

Image difference_picture(const Image& first, const Image& second) {
    check_sizes(first, second);
    if (first.transparent() || second.transparent())
        return difference_picture(laid_on(first, 255), laid_on(second, 255));
    Image picture(first.width, first.height);
    for (int y = 0; y < first.height; ++y) {
        const std::uint8_t* a = first.row(y);
        const std::uint8_t* b = second.row(y);
        std::uint8_t* out = picture.row(y);
        for (int x = 0; x < first.width; ++x, a += 3, b += 3, out += 3) {
            const int difference = pixel_difference(a, b);
            if (difference == 0) {
                const int grey = (77 * a[0] + 150 * a[1] + 29 * a[2]) >> 10;  // a quarter
                std::fill_n(out, 3, static_cast<std::uint8_t>(grey));
                continue;
            }
            // One level is seen at once; from 64 levels on red turns to yellow.
            out[0] = static_cast<std::uint8_t>(std::min(255, 120 + 4 * difference));
            out[1] = static_cast<std::uint8_t>(std::clamp(2 * (difference - 64), 0, 255));
            out[2] = 0;
        }
    }
    return picture;
}

}  // namespace fumon
