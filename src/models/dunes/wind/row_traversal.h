#pragma once

#include <cmath>

#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

/// The way over a grid of lines that follow the wind, a cell apart across it: they meet its rows
/// (or its columns, whichever the wind crosses more steeply) one by one and shift by a cell at most
/// from one to the next.
struct RowTraversal {
    RowTraversal(const DuneGround& ground, const BlowingWind& wind) {
        const double cells_x = wind.x / ground.dx;
        const double cells_y = wind.y / ground.dy;
        turned = std::abs(cells_x) > std::abs(cells_y);
        across = turned ? ground.ny : ground.nx;
        along = turned ? ground.nx : ground.ny;
        periodic_across = turned ? ground.periodic_y : ground.periodic_x;
        periodic_along = turned ? ground.periodic_x : ground.periodic_y;
        const double cells_along = turned ? cells_x : cells_y;
        forward = cells_along > 0.0;
        shift = (turned ? cells_y : cells_x) / std::abs(cells_along);
        distance = 1.0 / std::abs(cells_along);
    }

    /// How many lines reach every cell: past open edges they come in from the sides.
    [[nodiscard]] int lines() const {
        return periodic_across ? across
                               : across + static_cast<int>(std::ceil(std::abs(shift) * along)) + 3;
    }
    /// Line l is at cell l + first_cell() + shift n of the n-th row. One line more lies beside the
    /// first cell.
    [[nodiscard]] double first_cell() const {
        if (periodic_across) return 0.0;
        return shift > 0.0 ? -std::ceil(shift * along) - 1.0 : -1.0;
    }
    /// The number, along the grid, of the n-th row that lines meet; n may lie before the first one
    /// of a periodic grid.
    [[nodiscard]] int row(int n) const {
        const int going = ((n % along) + along) % along;
        return forward ? going : along - 1 - going;
    }

    bool turned = false;  ///< the grid's columns are the rows across the wind
    int across = 0;       ///< cells across
    int along = 0;        ///< cells along
    bool periodic_across = true;
    bool periodic_along = true;
    bool forward = true;    ///< toward larger numbers
    double shift = 0.0;     ///< cells across for each cell along
    double distance = 0.0;  ///< m for each cell along
};

}  // namespace fumon
