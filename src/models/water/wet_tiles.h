#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// Where water is or can come in a sub-step, by tiles of the grid, so that dry ground costs
/// nothing: what is dry, and has only dry cells around it, stays so where no rain falls.
class WetTiles {
  public:
    static constexpr int width = 64;  ///< cells eastward
    static constexpr int height = 8;
    /// Cells a side of the squares in which water is looked for. That in a square next to a tile
    /// counts as near it; in a sub-step of three stages it passes three faces at most.
    static constexpr int square = 4;

    WetTiles(int nx, int ny, bool periodic_x, bool periodic_y);

    /// Takes a cell for wet at all times: water may come in there.
    void keep_wet(int x, int y);

    /// Finds the tiles that water reaches from where its depth is not 0.
    void find(const Grid& depth, WorkerPool& pool);
    /// Takes all for wet: it rains.
    void find_all();

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    /// Whether water can be in a tile.
    [[nodiscard]] bool is_wet(int column, int row) const { return wet_[place(column, row)] != 0; }
    /// The grid's rows in `shares` parts with about as many wet cells each: where each begins, and
    /// the number of rows as the last.
    [[nodiscard]] std::vector<int> equal_shares(int shares) const;
    /// Calls `with(first_x, first_y, end_x, end_y)` for each tile that has become dry since the
    /// last search but one.
    template <class With>
    void for_each_dried(const With& with) const {
        for (int y = 0; y < rows_; ++y) {
            for (int x = 0; x < columns_; ++x) {
                const std::size_t tile = place(x, y);
                if (wet_[tile] != 0 || before_[tile] == 0) continue;
                with(x * width, y * height, std::min((x + 1) * width, nx_),
                     std::min((y + 1) * height, ny_));
            }
        }
    }

  private:
    [[nodiscard]] std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(x);
    }
    /// Of the cells of one row of squares: the columns of tiles that have water in or beside them.
    void find_columns(const Grid& depth, int squares_row);

    int nx_;
    int ny_;
    int columns_;
    int rows_;
    int squares_x_;  // of `square` cells a side
    int squares_y_;
    std::vector<std::vector<int>> near_columns_;  // of each column of tiles, its and next squares
    std::vector<std::vector<int>> near_rows_;
    std::vector<std::uint8_t> always_wet_;  // by squares
    std::vector<std::uint8_t> wet_squares_;
    std::vector<std::uint8_t> wet_columns_;  // by rows of squares and columns of tiles
    std::vector<std::uint8_t> wet_;          // by tiles
    std::vector<std::uint8_t> before_;
};

}  // namespace fumon
