#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// Rows of a bed side by side: site x of the row at place k is values[8·x + k]. So what is summed
/// along a row is summed from its first site on, of eight rows at once. A place without a row is
/// zero.
class RowBatch {
  public:
    static constexpr std::size_t rows = 8;

    explicit RowBatch(std::size_t nx) : nx_(nx), values_(nx * rows) {}

    /// Makes `count` rows of a bed, from `first` on, those of the batch from `place` on; the places
    /// up to `end` behind them are zero. The bed has nx columns.
    void take(const Grid& bed, int first, int count, std::size_t place = 0, std::size_t end = rows);

    /// Takes each row's mean from it or, if the bed is not periodic, its least-squares line, since
    /// a slope from end to end is not a wave. Exactly zero in a row whose departures are rounding
    /// only (below 1e-12 of its largest height).
    void detrend(bool periodic);

    /// Takes the mean of 2·radius + 1 sites about each site for it. Past the edges the row goes on
    /// with its other side if it is periodic, else with its outermost site. 2·radius < nx.
    void smooth(bool periodic, int radius);

    /// Puts the first `count` rows back as those of a bed from `first` on.
    void put(Grid& bed, int first, int count) const;

    [[nodiscard]] std::size_t nx() const { return nx_; }
    [[nodiscard]] const double* values() const { return values_.data(); }
    /// Σ f² of each row, as detrend() left it.
    [[nodiscard]] const std::array<double, rows>& squares() const { return squares_; }

  private:
    std::size_t nx_;
    std::vector<double> values_;
    std::vector<double> widened_;  ///< rows that go on past their edges
    std::array<double, rows> squares_{};
};

/// The waves of a row along x.
struct RowWaves {
    int first = 0;                ///< the site of its first upward crossing
    int last = 0;                 ///< and of its last one
    std::vector<double> reliefs;  ///< of the waves between two crossings, highest minus lowest site
    int crossings = 0;
};

/// Finds the waves of detrended rows, one RowWaves a place. A wave begins where a row rises into
/// its upper part, with hysteresis (a Schmitt trigger): below the mean − sd/2 arms it, the next
/// site above the mean + sd/2 counts and disarms it (for Sudo 2002's profile); sd is the standard
/// deviation of the row. None in a row without relief. Periodic: exact, the state in which the row
/// begins is the one in which it ends, and the last wave goes on to the first crossing. Else a rise
/// counts only after an arming site of the row itself.
void find_waves(const RowBatch& batch, bool periodic, std::array<RowWaves, RowBatch::rows>& waves);

}  // namespace fumon
