#pragma once

#include <vector>

#include "base/compensated_sum.h"
#include "models/shared/bed_diffusion.h"
#include "models/water/gully_parameters.h"
#include "models/water/kernels/sediment_vectors.h"
#include "models/water/row_neighbours.h"
#include "models/water/shallow_water.h"

namespace fumon {

class WorkerPool;

/// What flowing water does to its bed (Saeki & Okamura 2007, eqs. 4, 5, 12):
///
///     ∂z/∂t = transport + D ∇²z      q_s = K_f (K_t U^q S^γ − τ_c)^p u/U     S = |∇z|, mean slope
///                                                                            included
/// with the transport as
///
///  * incision: −|q_s| / (1 m);
///  * as printed: the sums of eq. (12), −(q_x[i+1] + q_x[i−1]) / 2dx and the same along y, which
///    points down the plane as in the paper: a sink that depends on the grid;
///  * conservative: −∇·q_s.
///
/// On gentle relief, as published: S and ∇·q_s from central differences, S one-sided at edges that
/// are not periodic and beside cells without data. Stable on gentle planes whose diffusion levels
/// what grows from cell to cell.
///
/// On steep relief, for any sub-step: S toward lower neighbours (Rouy & Tourin 1992), of
/// which there are none beyond open edges and in cells without data; no cell is cut below its
/// lowest neighbour (incise_downhill_row), and conserved sediment goes from the cell upstream to a
/// lower one (settle_downhill_row). What would settle at an open edge leaves with the water.
/// Transport as printed stays central, but no cell goes beyond its neighbours
/// (hold_between_neighbours).
///
/// Nothing is transported where the water stands or the bed is level. The diffusion crosses
/// periodic edges only; it goes by alternating directions (Peaceman & Rachford 1955), or in
/// explicit turns where cells are without data. A bed without transport (none) stays as it is.
class Sediment {
  public:
    /// Throws KeyError where a bed with cells without data would diffuse in over 10,000 explicit
    /// turns a step.
    Sediment(const GullyParameters& parameters, const WaterDomain& domain, int nx, int ny,
             WorkerPool& pool);

    /// Changes the bed (m, departures from the mean plane) over `dt` seconds of this flow; where
    /// SedimentLoads moves the grains, by diffusion alone.
    void advance(Grid& bed, const Water& water, double dt);

    /// What the transport has taken from the domain since the start, m³.
    [[nodiscard]] double removed() const { return -changed_.value() * domain_.dx * domain_.dy; }

    void serialise(StateArchive& archive) { changed_.serialise("sediment_changed", archive); }

  private:
    /// What a thread holds while it works on rows.
    struct Scratch {
        explicit Scratch(int nx)
            : bed(nx),
              along_x(nx),
              along_y(nx),
              flux(static_cast<std::size_t>(nx)),
              drop(static_cast<std::size_t>(nx)),
              changes(nx, BedDiffusion::rows_at_once) {}
        RowNeighbours bed, along_x, along_y;
        std::vector<double> flux;  ///< |q_s|, m²/s
        std::vector<double> drop;  ///< to the lowest neighbour, m; downhill only
        Grid changes;              ///< of a few rows by transport in a sub-step, m
    };

    void find_rim();
    void find_fluxes(const Grid& bed, const Water& water);
    void flux_row(const Grid& bed, const Water& water, int y, Scratch& scratch);
    void hold_at_walls(int y);
    void transport_row(const Grid& bed, const Water& water, double dt, int y, Scratch& scratch,
                       double* change);
    void settle_row(const Grid& bed, double dt, int y, Scratch& scratch, double* change);
    void diffuse_masked(Grid& bed, double dt);

    SedimentTransport transport_;
    bool steep_;
    bool downhill_;          ///< on steep relief, transport that is not as printed
    double diffusion_rate_;  ///< D, m²/s
    sediment::FluxLaw law_;
    WaterDomain domain_;
    int nx_;
    int ny_;
    WorkerPool& pool_;
    BedDiffusion diffusion_;
    Grid flux_x_;  ///< q_s, m²/s, where its neighbours count
    Grid flux_y_;
    Mask rim_;     ///< of conserved sediment downhill: 1 beside open edges and cells without data
    Grid change_;  ///< of the bed by transport in a sub-step, m; where cells are without data
    std::vector<double> row_changes_;
    CompensatedSum changed_;
};

}  // namespace fumon
