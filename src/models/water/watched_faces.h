#pragma once

#include <cstddef>
#include <vector>

#include "models/water/water_settings.h"

namespace fumon {

/// A face of a cell whose water a gauge counts.
struct WatchedFace {
    int x = 0;                       ///< column of the cell
    GridSide side = GridSide::west;  ///< of the cell
    double sign = 1.0;               ///< 1 where the gauge counts what leaves the cell, else −1
    std::size_t gauge = 0;           ///< its number
    double volume = 0.0;             ///< out of the cell in a sub-step, m³
};

/// Such faces by the cells' rows. A scheme that watches them adds the very volumes by which it
/// changes the depths; whoever has read them sets them to 0.
struct WatchedFaces {
    std::vector<std::vector<WatchedFace>> rows;

    /// `volume` m³ pass from cell (x, y) over its `side` to cell (to_x, to_y).
    void add(int x, int y, GridSide side, int to_x, int to_y, double volume) {
        for (WatchedFace& face : rows[static_cast<std::size_t>(y)]) {
            if (face.x == x && face.side == side) face.volume += volume;
        }
        for (WatchedFace& face : rows[static_cast<std::size_t>(to_y)]) {
            if (face.x == to_x && face.side == opposite(side)) face.volume -= volume;
        }
    }

    static GridSide opposite(GridSide side) {
        switch (side) {
            case GridSide::west:
                return GridSide::east;
            case GridSide::east:
                return GridSide::west;
            case GridSide::south:
                return GridSide::north;
            case GridSide::north:
                break;
        }
        return GridSide::south;
    }
};

}  // namespace fumon
