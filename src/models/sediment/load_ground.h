#pragma once

#include "base/grid.h"

namespace fumon {

/// Where grains lie and water moves them, fixed for a run.
struct LoadGround {
    int nx = 0;
    int ny = 0;
    double dx = 1.0;       ///< m
    double dy = 1.0;       ///< m
    double slope = 0.0;    ///< of the mean plane, which descends toward −y
    double slope_x = 0.0;  ///< … and toward +x
    bool periodic_x = true;
    bool periodic_y = true;
    Mask nodata;             ///< empty, or 1 outside the domain
    double gravity = 9.8;    ///< m/s²
    bool manning = false;    ///< friction is Manning's
    double friction = 0.01;  ///< C_f of τ/ρ = C_f U², or g n² of g n² U² / h^(1/3)
    Grid friction_map{};     ///< … of each cell; empty: the same everywhere

    /// Height of the mean plane at a cell's middle, 0 at the grid's south-west corner, m.
    [[nodiscard]] double plane(int x, int y) const {
        return slope * dy * (y + 0.5) - slope_x * dx * (x + 0.5);
    }
    [[nodiscard]] bool outside(int x, int y) const { return !nodata.empty() && nodata(x, y) != 0; }
};

}  // namespace fumon
