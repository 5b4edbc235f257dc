#include "measure/bed/row_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/bed/row_batch_vectors.h"

namespace fumon {

namespace {

/// Whether a row's state at its end is armed, see find_waves().
bool ends_armed(const RowBatch& batch, std::size_t place, double threshold) {
    for (std::size_t x = batch.nx(); x-- > 0;) {
        const double departure = batch.values()[x * RowBatch::rows + place];
        if (departure > threshold) return false;
        if (departure < -threshold) return true;
    }
    return false;
}

}  // namespace

void RowBatch::take(const Grid& bed, int first, int count, std::size_t place, std::size_t end) {
    for (int row = 0; row < count; ++row, ++place) {
        const auto heights = bed.row(first + row);
        double* to = values_.data() + place;
        for (std::size_t x = 0; x < nx_; ++x) to[x * rows] = heights[x];
    }
    for (; place < end; ++place) {
        for (std::size_t x = 0; x < nx_; ++x) values_[x * rows + place] = 0.0;
    }
}

void RowBatch::detrend(bool periodic) {
    row_batch_vectors::detrend(values_.data(), nx_, periodic, squares_.data());
}

void RowBatch::smooth(bool periodic, int radius) {
    const auto reach = static_cast<std::size_t>(radius);
    widened_.resize((nx_ + 2 * reach + 1) * rows);  // the last site is read, and not used
    const auto copy = [&](std::size_t from, std::size_t to) {
        std::copy_n(values_.data() + from * rows, rows, widened_.data() + to * rows);
    };
    std::copy(values_.begin(), values_.end(),
              widened_.begin() + static_cast<std::ptrdiff_t>(reach * rows));
    for (std::size_t beyond = 0; beyond <= reach; ++beyond) {
        if (beyond < reach) copy(periodic ? nx_ - reach + beyond : 0, beyond);
        copy(periodic ? beyond : nx_ - 1, nx_ + reach + beyond);
    }
    row_batch_vectors::smooth(widened_.data(), nx_, 2 * reach + 1, values_.data());
}

void RowBatch::put(Grid& bed, int first, int count) const {
    for (int row = 0; row < count; ++row) {
        const double* from = values_.data() + row;
        const auto to = bed.row(first + row);
        for (std::size_t x = 0; x < nx_; ++x) to[x] = from[x * rows];
    }
}

void find_waves(const RowBatch& batch, bool periodic, std::array<RowWaves, RowBatch::rows>& waves) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    row_batch_vectors::WaveSearch search{};
    for (std::size_t k = 0; k < RowBatch::rows; ++k) {
        waves[k].crossings = 0;
        waves[k].reliefs.resize(batch.nx() + 1);
        search.waves[k] = &waves[k];
        const double squares = batch.squares()[k];
        search.threshold[k] =
            squares == 0.0 ? infinite : 0.5 * std::sqrt(squares / static_cast<double>(batch.nx()));
        search.armed[k] = periodic && ends_armed(batch, k, search.threshold[k]) ? 1.0 : 0.0;
    }
    row_batch_vectors::find_waves(batch.values(), batch.nx(), search);
    for (std::size_t k = 0; k < RowBatch::rows; ++k) {
        RowWaves& row = waves[k];
        if (row.crossings == 0) {
            row.reliefs.clear();
            continue;
        }
        std::size_t closed = static_cast<std::size_t>(row.crossings) - 1;
        if (periodic) {
            const double highest = std::max(search.highest_before[k], search.highest[k]);
            const double lowest = std::min(search.lowest_before[k], search.lowest[k]);
            row.reliefs[closed++] = highest - lowest;
        }
        row.reliefs.resize(closed);
    }
}

}  // namespace fumon
