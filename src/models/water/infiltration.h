#pragma once

#include <utility>
#include <vector>

#include "base/compensated_sum.h"
#include "base/grid.h"
#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// What differs from cell to cell; a grid that is empty: the parameters' own everywhere.
struct Soil {
    Grid rate;     ///< m/s: f, or K
    Grid start;    ///< m/s: f0
    Grid suction;  ///< m: ψ Δθ
};

/// Water that the ground takes where there is some (f in m/s):
///
///  * constant: f;
///  * Horton (1933): f + (f0 − f) c, where c falls from 1 as e^(−k t), with t since the start
///    (HortonBy::clock) or such that ∫ (f + (f0 − f) e^(−k t)) dt is what the cell has taken
///    (HortonBy::intake), exact in each step. With a recovery r, 1 − c of a cell without water
///    falls as e^(−r t) (the drying curve of Rossman & Huber 2016, Storm Water Management Model
///    Reference Manual I, EPA/600/R-15/162A, section 4.2);
///  * Green & Ampt (1911): dF/dt = K (1 + ψ Δθ / F), F what the cell has taken, m; implicit in F.
///
/// What is left keeps its velocity.
class Infiltration {
  public:
    /// Throws KeyError for a recovery of another law.
    Infiltration(const GullyParameters& parameters, Soil soil, double cell_area, int nx, int ny,
                 WorkerPool& pool);

    [[nodiscard]] bool takes() const { return law_ != InfiltrationLaw::none; }
    /// Takes water over `dt` seconds from `time` on.
    void advance(Grid& depth, double time, double dt);
    /// What the ground has taken since the start, m³.
    [[nodiscard]] double volume() const { return volume_.value(); }
    /// F of every cell by Green & Ampt, m; else empty.
    [[nodiscard]] const Grid& total() const { return total_; }

    void serialise(StateArchive& archive);

  private:
    /// A parameter of each cell, or of a row of cells where all rows have the same.
    class OfCells {
      public:
        OfCells(Grid cells, double even, int nx)
            : cells_(std::move(cells)),
              row_(cells_.empty() ? static_cast<std::size_t>(nx) : 0, even) {}
        [[nodiscard]] const double* row(int y) const {
            return cells_.empty() ? row_.data() : cells_.row(y).data();
        }

      private:
        Grid cells_;
        std::vector<double> row_;
    };

    InfiltrationLaw law_;
    OfCells rate_;   ///< m/s
    OfCells start_;  ///< m/s
    double decay_;   ///< 1/s
    OfCells suction_;
    double cell_area_;
    WorkerPool& pool_;
    Grid total_;
    double recovery_;  ///< 1/s
    Grid fallen_;      ///< c of every cell, of Horton by intake
    std::vector<double> rows_;
    CompensatedSum volume_;
};

}  // namespace fumon
