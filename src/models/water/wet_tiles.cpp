#include "models/water/wet_tiles.h"

#include <bit>

#include "base/worker_pool.h"

namespace fumon {

namespace {

int pieces(int count, int size) {
    return (count + size - 1) / size;
}

/// Of each tile along an axis: the squares in it and next to it. Beyond a periodic edge these are
/// two, since the first may be a cell wide.
std::vector<std::vector<int>> squares_near(int tiles, int squares_a_tile, int squares,
                                           bool periodic) {
    std::vector<std::vector<int>> near(static_cast<std::size_t>(tiles));
    for (int tile = 0; tile < tiles; ++tile) {
        const int first = tile * squares_a_tile;
        const int end = std::min(first + squares_a_tile, squares);
        std::vector<int>& of_tile = near[static_cast<std::size_t>(tile)];
        for (int k = std::max(first - 1, 0); k < std::min(end + 1, squares); ++k)
            of_tile.push_back(k);
        if (!periodic) continue;
        const int second = std::min(1, squares - 1);
        if (first == 0) of_tile.insert(of_tile.end(), {squares - 1, squares - 1 - second});
        if (end == squares) of_tile.insert(of_tile.end(), {0, second});
    }
    return near;
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
      columns_(pieces(nx, width)),
      rows_(pieces(ny, height)),
      squares_x_(pieces(nx, square)),
      squares_y_(pieces(ny, square)),
      near_columns_(squares_near(columns_, width / square, squares_x_, periodic_x)),
      near_rows_(squares_near(rows_, height / square, squares_y_, periodic_y)),
      always_wet_(static_cast<std::size_t>(squares_x_) * static_cast<std::size_t>(squares_y_)),
      wet_squares_(always_wet_.size()),
      wet_columns_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(squares_y_)),
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
        for (int row = begin; row < end; ++row) find_columns(depth, row);
    });
    std::ranges::fill(wet_, std::uint8_t{0});
    for (int row = 0; row < rows_; ++row) {
        for (const int squares_row : near_rows_[static_cast<std::size_t>(row)]) {
            const std::uint8_t* columns = wet_columns_.data() + place(0, squares_row);
            for (int column = 0; column < columns_; ++column)
                wet_[place(column, row)] |= columns[column];
        }
    }
}

void WetTiles::find_columns(const Grid& depth, int squares_row) {
    const std::size_t first =
        static_cast<std::size_t>(squares_row) * static_cast<std::size_t>(squares_x_);
    std::uint8_t* squares = wet_squares_.data() + first;
    std::copy_n(always_wet_.data() + first, squares_x_, squares);
    for (int y = squares_row * square; y < std::min((squares_row + 1) * square, ny_); ++y)
        mark_wet(depth.row(y).data(), nx_, squares);
    for (int column = 0; column < columns_; ++column) {
        std::uint8_t wet = 0;
        for (const int k : near_columns_[static_cast<std::size_t>(column)]) wet |= squares[k];
        wet_columns_[place(column, squares_row)] = wet;
    }
}

std::vector<int> WetTiles::equal_shares(int shares) const {
    std::vector<long long> wet_above{0};  // tiles of each row of cells, summed
    for (int y = 0; y < ny_; ++y) {
        const std::uint8_t* row = wet_.data() + place(0, y / height);
        if (y % height != 0) {
            const long long last = wet_above.back() - wet_above[wet_above.size() - 2];
            wet_above.push_back(wet_above.back() + last);
        } else {
            wet_above.push_back(wet_above.back() + std::count(row, row + columns_, 1));
        }
    }
    std::vector<int> begins;
    for (int share = 0; share < shares; ++share) {
        const auto from = std::ranges::lower_bound(wet_above, wet_above.back() * share / shares);
        begins.push_back(static_cast<int>(from - wet_above.begin()));
    }
    begins.push_back(ny_);
    return begins;
}

}  // namespace fumon
