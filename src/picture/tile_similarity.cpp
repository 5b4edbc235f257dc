#include "picture/tile_similarity.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

namespace {

constexpr int tile_side = 8;  // pixels

/// Sums over one tile's pixels of two luminances a and b.
struct TileSums {
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t aa = 0;
    std::int64_t bb = 0;
    std::int64_t ab = 0;
};

/// 256 times the luminance of a row of `count` pixels.
void luminance(const std::uint8_t* pixels, int count, std::int32_t* values) {
    for (int x = 0; x < count; ++x, pixels += 3)
        values[x] = 77 * pixels[0] + 150 * pixels[1] + 29 * pixels[2];
}

double structural_similarity(const TileSums& sums, int pixels) {
    constexpr double scale = 256.0;
    constexpr double c1 = (0.01 * 255 * scale) * (0.01 * 255 * scale);
    constexpr double c2 = (0.03 * 255 * scale) * (0.03 * 255 * scale);
    const std::int64_t n = pixels;
    const auto mean_a = static_cast<double>(sums.a) / static_cast<double>(n);
    const auto mean_b = static_cast<double>(sums.b) / static_cast<double>(n);
    const auto degrees = static_cast<double>(n * std::max<std::int64_t>(n - 1, 1));
    const auto variance_a = static_cast<double>(n * sums.aa - sums.a * sums.a) / degrees;
    const auto variance_b = static_cast<double>(n * sums.bb - sums.b * sums.b) / degrees;
    const auto covariance = static_cast<double>(n * sums.ab - sums.a * sums.b) / degrees;
    return (2.0 * mean_a * mean_b + c1) * (2.0 * covariance + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

/// Where tiles begin along a side of `pixels`.
std::vector<int> tile_starts(int pixels) {
    std::vector<int> starts;
    for (int start = 0; start + tile_side <= pixels; start += tile_side) starts.push_back(start);
    if (pixels % tile_side != 0) starts.push_back(std::max(pixels - tile_side, 0));
    return starts;
}

}  // namespace

TileSimilarity tile_similarity(const Image& first, const Image& second) {
    const int tile_width = std::min(tile_side, first.width);
    const int tile_height = std::min(tile_side, first.height);
    const std::vector<int> starts = tile_starts(first.width);
    const auto width = static_cast<std::size_t>(first.width);
    std::vector<std::int32_t> a(width * static_cast<std::size_t>(tile_height));
    std::vector<std::int32_t> b(a.size());
    TileSimilarity least;
    for (const int y : tile_starts(first.height)) {
        for (int row = 0; row < tile_height; ++row) {
            const std::size_t offset = width * static_cast<std::size_t>(row);
            luminance(first.row(y + row), first.width, a.data() + offset);
            luminance(second.row(y + row), first.width, b.data() + offset);
        }
        for (const int x : starts) {
            TileSums sums;
            for (int row = 0; row < tile_height; ++row) {
                const std::size_t offset =
                    width * static_cast<std::size_t>(row) + static_cast<std::size_t>(x);
                for (int column = 0; column < tile_width; ++column) {
                    const std::int64_t left = a[offset + static_cast<std::size_t>(column)];
                    const std::int64_t right = b[offset + static_cast<std::size_t>(column)];
                    sums.a += left;
                    sums.b += right;
                    sums.aa += left * left;
                    sums.bb += right * right;
                    sums.ab += left * right;
                }
            }
            const double similarity = structural_similarity(sums, tile_width * tile_height);
            if (similarity < least.smallest) least = {similarity, x, y};
        }
    }
    return least;
}

}  // namespace fumon
