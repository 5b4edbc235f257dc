#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/random.h"
#include "models/avalanche/slope_relaxation.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class Plants;
class WorkerPool;

/// Slabs of sand that hop at random (Werner 1995). As many cells are picked in a step as there are;
/// from a picked cell that is not in shadow a slab hops by L along the wind, and at each landing it
/// comes to rest with a probability, that of sand, of rock, or 1 in shadow; else it hops on. A slab
/// that is thinner than usual is what the cell still has. Where a landing lies between cells, the
/// nearer one is the likelier, in proportion. A shadow of strength r (0 … 1) is one with
/// probability r.
///
/// In parallel order a step is divided into sub-steps. Picks of a sub-step read the bed at its
/// start; what they move is added up in whole numbers, so that no result depends on threads, and
/// avalanches follow, which slide on through the sub-steps and end with the step. The picks fall on
/// rows as an exact multinomial, each row by its own random stream. In sequential order each slab's
/// avalanches have ended before the next pick.
class SlabTransport {
  public:
    SlabTransport(const DunesParameters& parameters, const DuneGround& ground, double slab_height,
                  const ShadowTangents& shadow, std::uint64_t seed, WorkerPool& pool);

    struct Avalanches {
        SlopeRelaxation& slopes;
        int most_passes;
        int passes = 0;  ///< most of a sub-step
        bool at_rest = true;
    };

    /// `plants`: what holds the sand (see Plants), or null.
    void step(DuneBed& bed, const BlowingWind& wind, const Plants* plants, std::int64_t step,
              WindShadow& shadow, Avalanches& avalanches);

  private:
    struct Cell {
        int x = 0;
        int y = 0;
    };

    struct Landing {
        Cell place;
        std::int64_t slab;
    };

    /// What a thread picks from its rows [begin, end).
    struct Share {
        int begin;
        int end;
        std::vector<std::int64_t> taken;  ///< of the cells of the row at hand
        std::vector<int> picked;          ///< those that are not 0
        std::vector<Landing> beyond;      ///< in rows of other threads
    };

    void step_in_parallel(DuneBed& bed, const BlowingWind& wind, std::int64_t step,
                          WindShadow& shadow, Avalanches& avalanches);
    void step_in_sequence(DuneBed& bed, const BlowingWind& wind, std::int64_t step,
                          Avalanches& avalanches);
    [[nodiscard]] std::int64_t pick_row(const DuneBed& bed, const BlowingWind& wind,
                                        const Grid& shade, int y, RandomStream& stream,
                                        Share& share);
    [[nodiscard]] std::int64_t add_influx(const DuneBed& bed, const BlowingWind& wind,
                                          const Grid& shade, std::int64_t substep);
    template <class Shade>
    bool hop(const DuneBed& bed, const BlowingWind& wind, const Shade& shade, double from_x,
             double from_y, RandomStream& stream, Cell& place) const;
    [[nodiscard]] double marched_shade(const DuneBed& bed, const BlowingWind& wind, int x, int y,
                                       std::int64_t highest) const;
    /// The probability that a picked slab stays where it is.
    [[nodiscard]] double held(double shade, int x, int y) const;

    DunesParameters parameters_;
    DuneGround ground_;
    std::int64_t slab_;
    ShadowTangents shadow_;
    std::uint64_t seed_;
    WorkerPool& pool_;
    const Plants* plants_ = nullptr;  ///< of the step
    double mean_ = 0.0;               ///< m, of the surface at the step's start
    FloorRange rock_range_;
    FixedPointGrid change_;
    std::vector<std::int64_t> picks_;  ///< of each row
    std::vector<std::int64_t> lost_;   ///< by each row
};

}  // namespace fumon
