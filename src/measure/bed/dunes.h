#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/grid.h"
#include "base/snapshot_lookup.h"
#include "measure/bed/dune_components.h"

namespace fumon {

/// What counts as a separate dune.
struct DuneCriteria {
    double level_share = 0.3;       ///< of the bed's highest cell: a dune stands above it
    std::int64_t least_cells = 20;  ///< a smaller piece is no dune
};

/// Where the wind blows to over dunes, for their horns.
struct WindOnGrid {
    HorizontalDirection direction{};
    double cell_aspect = 1.0;  ///< dy/dx: how many columns' breadths a row is wide
    bool known = true;         ///< false: dunes have no horns
};

/// One dune: a piece of the bed above the level. Looking downwind, left is left.
struct Dune {
    std::int64_t area = 0;  ///< cells
    double height = 0.0;    ///< of its highest cell, in heights of the bed (not above the level)
    double volume = 0.0;    ///< sum of the heights of its cells, heights × cells
    double centre_x = 0.0;  ///< centroid of its cells, in sites, within the box
    double centre_y = 0.0;
    /// How many sites its two sides lie downwind of its middle. With the wind along x: its centre
    /// line (the mean x of its cells, row by row) is fitted by a + b·(y − y_m) + c·(y − y_m)² about
    /// its middle row y_m, and the lag is c times the square of half its width. Positive: horns
    /// downwind, as a barchan's; negative: upwind, as a parabolic dune's. Under another wind,
    /// strips along it, a site wide, stand for rows, and the way along it for x. NaN where it has
    /// fewer than 3 rows.
    double horn_lag = std::numeric_limits<double>::quiet_NaN();
    /// How far the dune reaches downwind on either side of its middle row beyond where that row
    /// ends, in sites; 0 without a horn. A slanting bar has one long "horn" only.
    double left_horn = 0.0;
    double right_horn = 0.0;
};

/// The separate dunes of a bed, and means over them (NaN where there is none).
struct DuneField {
    std::vector<Dune> dunes;
    double covered_share = 0.0;  ///< share of all cells above the level, whether or not of a dune
    double mean_area = std::numeric_limits<double>::quiet_NaN();
    double mean_height = std::numeric_limits<double>::quiet_NaN();
    double mean_volume = std::numeric_limits<double>::quiet_NaN();
    double share_horns_downwind = std::numeric_limits<double>::quiet_NaN();  ///< of those with one
    double mean_horn_lag = std::numeric_limits<double>::quiet_NaN();         ///< NaN lags left out
};

/// The horn lag of one piece's cells (Dune::horn_lag); NaN where no wind is known.
double horn_lag(std::span<const RowRun> runs, const WindOnGrid& wind);

/// Dunes are the 8-connected pieces of cells higher than level_share times the highest cell, of at
/// least least_cells cells, that do not wrap round a periodic bed. Heights are
/// taken as they are, above zero: this is for dunes on bare ground at height 0. On a thick bed the
/// level cuts nothing, and the whole bed is one piece that wraps. A piece of two dunes that touch
/// counts once. In a bed that is not periodic, dunes cut off by the edge count as they are. Where
/// no cell is higher than 0 nothing is covered.
DuneField separate_dunes(const Grid& bed, bool periodic, const DuneCriteria& criteria = {},
                         const WindOnGrid& wind = {});

}  // namespace fumon
