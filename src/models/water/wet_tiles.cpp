#include "models/water/wet_tiles.h"

#include <bit>

#include "base/worker_pool.h"

namespace fumon {

namespace {

int pieces(int count, int size) {
    return (count + size - 1) / size;
}

/// Marks the squares of a row of cells in which a depth is not 0.
void mark_wet(const double* depth, int count, std::uint8_t* squares) {
    for (int first = 0; first < count; first += WetTiles::square) {
        const int end = std::min(first + WetTiles::square, count);
        std::uint64_t bits = 0;
        for (int x = first; x < end; ++x) bits |= std::bit_cast<std::uint64_t>(depth[x]);
        squares[first / WetTiles::square] |= bits != 0 ? 1 : 0;
    }
}

}  // namespace

WetTiles::WetTiles(int nx, int ny, bool periodic_x, bool periodic_y)
    : nx_(nx),
      ny_(ny),
      periodic_x_(periodic_x),
      periodic_y_(periodic_y),
      columns_(pieces(nx, width)),
      rows_(pieces(ny, height)),
      squares_x_(pieces(nx, square)),
      squares_y_(pieces(ny, square)),
      always_wet_(static_cast<std::size_t>(squares_x_) * static_cast<std::size_t>(squares_y_)),
      wet_squares_(always_wet_.size()),
      wet_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      before_(wet_.size()) {}

void WetTiles::keep_wet(int x, int y) {
    always_wet_[static_cast<std::size_t>(y / square) * static_cast<std::size_t>(squares_x_) +
                static_cast<std::size_t>(x / square)] = 1;
}

void WetTiles::find_all() {
    before_ = wet_;
    std::ranges::fill(wet_, std::uint8_t{1});
}

void WetTiles::find(const Grid& depth, WorkerPool& pool) {
    before_.swap(wet_);
    pool.for_ranges(squares_y_, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(squares_x_);
            std::copy_n(always_wet_.data() + first, squares_x_, wet_squares_.data() + first);
            for (int y = row * square; y < std::min((row + 1) * square, ny_); ++y)
                mark_wet(depth.row(y).data(), nx_, wet_squares_.data() + first);
        }
    });
    const auto wet_square = [&](int x, int y) {
        if (periodic_x_) x = (x + squares_x_) % squares_x_;
        if (periodic_y_) y = (y + squares_y_) % squares_y_;
        if (x < 0 || x >= squares_x_ || y < 0 || y >= squares_y_) return false;
        return wet_squares_[static_cast<std::size_t>(y) * static_cast<std::size_t>(squares_x_) +
                            static_cast<std::size_t>(x)] != 0;
    };
    // Two squares, since beyond a periodic edge the first may be a cell wide.
    constexpr int wide = width / square;
    constexpr int high = height / square;
    for (int y = 0; y < rows_; ++y) {
        for (int x = 0; x < columns_; ++x) {
            bool wet = false;
            for (int at_y = y * high - 2; at_y <= (y + 1) * high + 1 && !wet; ++at_y) {
                for (int at_x = x * wide - 2; at_x <= (x + 1) * wide + 1 && !wet; ++at_x)
                    wet = wet_square(at_x, at_y);
            }
            wet_[place(x, y)] = wet ? 1 : 0;
        }
    }
}

}  // namespace fumon
