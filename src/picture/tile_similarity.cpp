#include "picture/tile_similarity.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "base/worker_pool.h"
#include "picture/pixels/level_vectors.h"

namespace fumon {

namespace {

using level_vectors::middle_luminance;
using level_vectors::tile_side;
using level_vectors::TileSums;

double structural_similarity(const TileSums& sums, int pixels) {
    constexpr double scale = 256.0;
    constexpr double c1 = (0.01 * 255 * scale) * (0.01 * 255 * scale);
    constexpr double c2 = (0.03 * 255 * scale) * (0.03 * 255 * scale);
    const std::int64_t n = pixels;
    // Variances are the same about any middle, to the last digit: all sums are whole numbers.
    const std::int64_t whole_a = sums.a + n * middle_luminance;
    const std::int64_t whole_b = sums.b + n * middle_luminance;
    const auto mean_a = static_cast<double>(whole_a) / static_cast<double>(n);
    const auto mean_b = static_cast<double>(whole_b) / static_cast<double>(n);
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

/// Whether one tile is to be told of before another: it is less similar, or comes first.
bool comes_before(const TileSimilarity& one, const TileSimilarity& other) {
    if (one.smallest != other.smallest) return one.smallest < other.smallest;
    if (one.smallest >= 1.0) return false;
    return one.y != other.y ? one.y < other.y : one.x < other.x;
}

/// The tiles of two pictures of one size, a row of tiles after the other.
class Tiles {
  public:
    Tiles(const Image& first, const Image& second, const IgnoredPixels& ignored)
        : first_(first),
          second_(second),
          ignored_(ignored),
          width_(static_cast<std::size_t>(first.width)),
          rows_(std::min(tile_side, first.height)),
          starts_(tile_starts(first.width)),
          a_(width_ * static_cast<std::size_t>(rows_)),
          b_(a_.size()),
          sums_(starts_.size()) {}

    /// The least similar of those whose top row is y.
    TileSimilarity least_at(int y) {
        for (int row = 0; row < rows_; ++row) {
            const std::size_t offset = width_ * static_cast<std::size_t>(row);
            level_vectors::luminance_row(first_.row(y + row), first_.width, a_.data() + offset);
            level_vectors::luminance_row(second_.row(y + row), first_.width, b_.data() + offset);
        }
        return some_ignored(y) ? least_of_others(y) : least_of_all(y);
    }

  private:
    [[nodiscard]] bool some_ignored(int y) const {
        if (!ignored_.any()) return false;
        const std::uint8_t* flags = ignored_.row(y);
        return std::find(flags, flags + a_.size(), std::uint8_t{1}) != flags + a_.size();
    }

    TileSimilarity least_of_all(int y) {
        if (first_.width < tile_side) return least_of_others(y);
        const int whole = first_.width / tile_side;
        level_vectors::tile_sums(a_.data(), b_.data(), width_, rows_, whole, sums_.data());
        const auto last = static_cast<std::size_t>(starts_.back());
        level_vectors::tile_sums(a_.data() + last, b_.data() + last, width_, rows_, 1,
                                 &sums_.back());
        TileSimilarity least;
        for (std::size_t tile = 0; tile < starts_.size(); ++tile) {
            const double similarity = structural_similarity(sums_[tile], tile_side * rows_);
            if (similarity < least.smallest) least = {similarity, starts_[tile], y};
        }
        return least;
    }

    /// The same pixel by pixel, of those that are not ignored.
    [[nodiscard]] TileSimilarity least_of_others(int y) const {
        TileSimilarity least;
        for (const int x : starts_) {
            TileSums sums;
            int pixels = 0;
            for (int row = 0; row < rows_; ++row) {
                const std::size_t offset = width_ * static_cast<std::size_t>(row);
                const auto end = std::min(width_, static_cast<std::size_t>(x) + tile_side);
                for (auto column = static_cast<std::size_t>(x); column < end; ++column) {
                    if (ignored_.any() && ignored_.row(y + row)[column] != 0) continue;
                    const std::int64_t left = a_[offset + column];
                    const std::int64_t right = b_[offset + column];
                    sums.a += left;
                    sums.b += right;
                    sums.aa += left * left;
                    sums.bb += right * right;
                    sums.ab += left * right;
                    ++pixels;
                }
            }
            if (pixels == 0) continue;
            const double similarity = structural_similarity(sums, pixels);
            if (similarity < least.smallest) least = {similarity, x, y};
        }
        return least;
    }

    const Image& first_;
    const Image& second_;
    const IgnoredPixels& ignored_;
    std::size_t width_;
    int rows_;  ///< of a tile
    std::vector<int> starts_;
    std::vector<std::int16_t> a_;
    std::vector<std::int16_t> b_;
    std::vector<TileSums> sums_;
};

}  // namespace

TileSimilarity tile_similarity(const Image& first, const Image& second,
                               const IgnoredPixels& ignored, WorkerPool& pool) {
    const std::vector<int> tops = tile_starts(first.height);
    TileSimilarity least;
    std::mutex mutex;
    pool.for_ranges(static_cast<int>(tops.size()), [&](int begin, int end) {
        Tiles tiles(first, second, ignored);
        TileSimilarity mine;
        for (int row = begin; row < end; ++row) {
            const TileSimilarity one = tiles.least_at(tops[static_cast<std::size_t>(row)]);
            if (comes_before(one, mine)) mine = one;
        }
        const std::lock_guard lock(mutex);
        if (comes_before(mine, least)) least = mine;
    });
    return least;
}

TileSimilarity tile_similarity(const Image& first, const Image& second) {
    WorkerPool pool(1);
    return tile_similarity(first, second, {}, pool);
}

}  // namespace fumon
