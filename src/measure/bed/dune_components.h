#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// Cells (first … last, y) of one row. Of a piece that crosses an edge of a periodic bed, x and y
/// go on past the edge, so that the piece lies together: they are then below 0 or above nx, ny.
struct RowRun {
    int y = 0;
    int first = 0;
    int last = 0;

    friend bool operator==(const RowRun&, const RowRun&) = default;
};

/// Cells that hang together by sides or corners.
struct DuneComponent {
    std::size_t first_run =
        0;  ///< its runs are DuneComponents::runs[first_run … first_run + runs − 1]
    std::size_t runs = 0;
    std::int64_t cells = 0;
    bool wraps = false;  ///< hangs together with itself round the periodic bed: a band, not a dune
    std::size_t root = 0;  ///< which of all runs of the bed, row after row, its first one is
};

/// The pieces of a bed, in the order of their southernmost (then westernmost) cells in the bed.
struct DuneComponents {
    std::vector<RowRun> runs;
    std::vector<DuneComponent> pieces;

    [[nodiscard]] std::span<const RowRun> runs_of(const DuneComponent& piece) const {
        return std::span(runs).subspan(piece.first_run, piece.runs);
    }
};

/// The 8-connected pieces of the cells higher than `level`. The coordinates of a piece that wraps
/// are not unique. Memory grows with the number of runs, not of cells.
DuneComponents dune_components(const Grid& bed, double level, bool periodic);

/// Pieces of pieces, and of which one each is.
struct ComponentsWithin {
    DuneComponents components;
    std::vector<std::size_t> pieces;
};

/// The 8-connected pieces of what is higher than a share of the height of the piece of the bed that
/// it lies in (one height a piece; 0: of that one nothing).
ComponentsWithin components_within(const Grid& bed, const DuneComponents& pieces,
                                   std::span<const double> heights, double share, bool periodic);

}  // namespace fumon
