#pragma once

#include <cstddef>
#include <cstdint>

#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dune_ground.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/transport/kernels/drift_vectors.h"
#include "models/dunes/transport/saturation_hops.h"
#include "models/dunes/transport/wind_over_bed.h"
#include "models/shared/fixed_point_lengths.h"

namespace fumon {

class WorkerPool;

/// Hops of the sand in the air: all of it moves by L along the wind and is spread over 3 × 3 cells
/// (HopSpread). Over height (see hop_factor), before walls and in a bent wind each cell has a hop
/// of its own. What division leaves over goes to the middle cell, so no sand is lost.
class Saltation {
  public:
    Saltation(const DunesParameters& parameters, const DuneGround& ground, WorkerPool& pool);

    /// One hop of all of `bed.moving`, which stays as it is; bed.outflow takes what leaves over
    /// open edges.
    void hop(DuneBed& bed, const WindOverBed& wind, const SaturationHops& hops);
    /// Hops in from beyond open edges, of cells from each of which `amount` hops; after hop(),
    /// with the same hops. Counted as bed.inflow.
    void add_influx(DuneBed& bed, const BlowingWind& wind, std::int64_t amount);

    /// Where sand came down; whoever reads it sets it to 0 for the next hop.
    [[nodiscard]] FixedPointGrid& arrived() { return arrived_; }

  private:
    struct Spreads;

    void hop_along_walls(DuneBed& bed, const WindOverBed& wind);
    std::int64_t hop_rows_alike(const DuneBed& bed, const Spreads& spread, int begin, int end);
    std::int64_t add_pieces(const drift_vectors::Pieces& pieces, std::size_t j, std::size_t cells,
                            std::int64_t x, int y);
    template <class Spread>
    std::int64_t hop_rows(const DuneBed& bed, const Spread& spread, int begin, int end);
    template <class Spread>
    void hop_all(DuneBed& bed, const Spread& spread, double reach_y);

    DunesParameters parameters_;
    DuneGround ground_;
    SaturationHops hops_;  ///< of the last hop
    WorkerPool& pool_;
    FixedPointGrid arrived_;
};

/// How much further than over the mean surface hops reach at a height so many metres above it.
double hop_factor(const DunesParameters& parameters, double above_mean);

}  // namespace fumon
