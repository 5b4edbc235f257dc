#pragma once

#include <cstdint>

namespace fumon {

/// The ground over which winds blow.
struct DuneGround {
    int nx = 0;
    int ny = 0;
    double dx = 1.0;  ///< m
    double dy = 1.0;  ///< m
    bool periodic_x = true;
    bool periodic_y = true;

    /// Where a cell number along an axis lies in the grid; −1 beyond an open edge.
    [[nodiscard]] int column(std::int64_t x) const { return place(x, nx, periodic_x); }
    [[nodiscard]] int row(std::int64_t y) const { return place(y, ny, periodic_y); }

  private:
    [[nodiscard]] static int place(std::int64_t cell, int count, bool periodic) {
        if (cell >= 0 && cell < count) return static_cast<int>(cell);
        if (!periodic) return -1;
        return static_cast<int>(((cell % count) + count) % count);
    }
};

}  // namespace fumon
