#include "film/card_backdrop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

namespace {

constexpr int radii_per_side = 40;  // the shorter side is that many radii
constexpr int blur_pass_count = 3;
constexpr std::uint8_t behind = 16;          // what a picture that can be seen through is laid on
constexpr std::uint32_t fraction = 1U << 8;  // levels are kept that much finer
constexpr std::uint32_t part = 1;            // of the brightness is left …
constexpr std::uint32_t of = 3;              // … in so many

/// The mean over `radius` values to both sides of every `stride`-th of `count`; beyond the ends the
/// last value goes on.
void average(std::uint32_t* values, std::size_t count, std::size_t stride, int radius,
             std::vector<std::uint32_t>& line) {
    line.resize(count);
    for (std::size_t i = 0; i < count; ++i) line[i] = values[i * stride];
    const auto at = [&](std::ptrdiff_t i) {
        return line[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(count) - 1))];
    };
    const auto width = static_cast<std::uint32_t>(2 * radius + 1);
    std::uint32_t sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += at(i);
    for (std::size_t i = 0; i < count; ++i) {
        values[i * stride] = (sum + width / 2) / width;
        const auto here = static_cast<std::ptrdiff_t>(i);
        sum += at(here + radius + 1) - at(here - radius);
    }
}

/// Thresholds of ordered dither (Bayer 1973), each of 0 … 15 once.
constexpr std::array<std::array<std::uint32_t, 4>, 4> thresholds{
    {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

}  // namespace

Image card_backdrop(const Image& picture) {
    const Image opaque = picture.transparent() ? composited_on(picture, behind) : picture;
    Image made(opaque.width, opaque.height);
    const auto width = static_cast<std::size_t>(opaque.width);
    const auto height = static_cast<std::size_t>(opaque.height);
    const int radius = std::min(opaque.width, opaque.height) / radii_per_side;
    std::vector<std::uint32_t> values(opaque.rgb.size());
    std::ranges::transform(opaque.rgb, values.begin(),
                           [](std::uint8_t level) { return level * fraction * part / of; });
    std::vector<std::uint32_t> line;
    for (int pass = 0; pass < blur_pass_count; ++pass) {
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t channel = 0; channel < 3; ++channel)
                average(&values[3 * y * width + channel], width, 3, radius, line);
        for (std::size_t at = 0; at < 3 * width; ++at)
            average(&values[at], height, 3 * width, radius, line);
    }
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint32_t threshold = thresholds[y % 4][x % 4] * (fraction / 16);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::size_t at = 3 * (y * width + x) + channel;
                made.rgb[at] = static_cast<std::uint8_t>((values[at] + threshold) / fraction);
            }
        }
    }
    return made;
}

}  // namespace fumon
