#pragma once

#include <memory>
#include <vector>

#include "base/compensated_sum.h"
#include "base/state_archive.h"
#include "models/water/finite_volume_strip.h"
#include "models/water/shallow_water.h"
#include "models/water/shore_planes.h"
#include "models/water/water_edges.h"
#include "models/water/wet_tiles.h"

namespace fumon {

class WorkerPool;

/// Shallow water by a well-balanced finite-volume scheme of second order in space and time, for wet
/// and dry ground:
///
///     ∂h/∂t + ∂(hu)/∂x + ∂(hv)/∂y = rain
///     ∂(hu)/∂t + ∂(hu² + g h²/2)/∂x + ∂(huv)/∂y = −g h ∂z/∂x + g h·slope_x − C_f |u| u
///     ∂(hv)/∂t + ∂(huv)/∂x + ∂(hv² + g h²/2)/∂y = −g h ∂z/∂y − g h·slope − C_f |u| v
///
/// with C_f constant (published, or g/C² after Chézy) or g n² / h^(1/3) (Manning).
///
/// Limited linear reconstruction of depth, surface and velocities (MUSCL), hydrostatic
/// reconstruction of the bed's steps (Audusse et al. 2004; Chen & Noelle 2017), HLLC fluxes, Heun's
/// two stages with friction implicit in each. Where shores have planes (ShorePlanes), cells hold
/// means (mean_vectors.h), and if no loads are carried a step has three stages of third order (Shu
/// & Osher 1988). Water at rest stays at rest, depth never becomes
/// negative (outward fluxes are cut to the water that is there) and no water is lost; a uniform
/// film at V = √(g h·slope/C_f) stays uniform. Water thinner than 10⁻⁹ m does not move.
///
/// What upwinding levels: where friction holds the flow across a wave, its fluxes at faces level
/// the surface at a rate of 2 √(gh) sin⁴(k dx/2) / dx beside that of the equations, (g h² / C_f V)
/// sin²(k dx) / dx². Waves that hang on this levelling, as the bed's under a thin film on coarse
/// cells, feel it at some ten cells and less: bed waves of 10 cells of 4 m under 10 mm of water
/// grow by .0126 /s for .0107 of central differences and .0114 of the equations, of 10 cells of 1 m
/// by .0301 for .0292 and .0302. It falls with the square of the cells in a wave.
///
/// Edges: periodic; wall, a mirror; open, and likewise cells without data: a dry step of equal
/// height over which water falls, so that it leaves freely and none comes in. Stretches of edges
/// that are not periodic may have a kind of their own, or a discharge or level (WaterEdges).
class FiniteVolumeScheme : public ShallowWaterScheme {
  public:
    /// `roughness`: n, C or C_f of each cell, of the parameters' friction law; empty: theirs
    /// everywhere.
    FiniteVolumeScheme(const GullyParameters& parameters, const WaterDomain& domain,
                       WorkerPool& pool, const Grid& roughness = {});

    [[nodiscard]] double step_at_courant_one(const Water& water) const override;
    double advance(Water& water, const Grid& bed, double dt, double rain) override;
    [[nodiscard]] double left() const override { return left_ + left_with_flow_.value(); }
    [[nodiscard]] double entered() const override { return entered_.value(); }
    void record(FaceFlows& flows) override { flows_ = &flows; }
    void watch(WatchedFaces& faces) override { watched_ = &faces; }
    void convert_to_means(Water& water, const Grid& bed) override;
    void set_rain(const Grid* rain) override { rain_ = rain; }
    void set_time(double time) override;
    [[nodiscard]] double edge_step_at_courant_one(double time, const Grid& bed) const override;
    void serialise(StateArchive& archive) override;

  private:
    /// One of the Euler steps that make a step: two, or three where shores have planes and no loads
    /// are carried.
    struct Stage {
        const Water& from;
        const Water* before;  ///< the step's start, of which later stages keep a share
        Water& to;
        const Grid& bed;
        double dt;
        double kept;    ///< that share
        double weight;  ///< of what the stage changes, in what the step does
    };

    /// A face of a cell through which water leaves the domain, or where it flows over an edge.
    struct Outlet {
        int x = 0;
        GridSide side = GridSide::west;
        bool is_flow = false;
        double volume = 0.0;  ///< of a stage, m³/s, outward
    };
    struct CellIndex {
        int x = 0;
        int y = 0;
    };
    /// A rectangle of cells that is advanced at once.
    struct Part {
        int first_x = 0;
        int end_x = 0;
        int first_y = 0;
        int end_y = 0;
    };
    struct Volumes {
        double left = 0.0;  ///< of a stage, m³/s
        double entered = 0.0;
    };

    void prepare(const Water& water);
    void find_outlets();
    void keep_inlets_wet();
    void find_wet(const Water& water, double rain);
    void run(const Stage& stage);
    void deliver_deficits(Water& water, double dt);
    void advance_share(const Stage& stage, finite_volume::Strip& strip, int first_row,
                       int last_row);
    void advance_part(const Stage& stage, finite_volume::Strip& strip, const Part& part);
    void advance_block(const Stage& stage, finite_volume::Strip& strip, int first_row,
                       int last_row);
    void load_row(const Stage& stage, finite_volume::Strip& strip, int y) const;
    void load_ghost_row(const Stage& stage, finite_volume::Strip& strip, int y) const;
    void load_ghost_cells(const Stage& stage, finite_volume::Strip& strip, int k, int y,
                          CellIndex edge, CellIndex inner, int beyond) const;
    void set_edge_flux(finite_volume::Strip& strip, int k, int y, GridSide side, int cell) const;
    void set_shore_fluxes(finite_volume::Strip& strip, int y) const;
    void compute_edge_x(finite_volume::Strip& strip, int y) const;
    void compute_edge_y(finite_volume::Strip& strip, int y) const;
    void bound_speeds(const Stage& stage, finite_volume::Strip& strip, int y) const;
    void keep_flows(const Stage& stage, finite_volume::Strip& strip, int y) const;
    void count_left(const finite_volume::Strip& strip, int y);
    void count_watched(const Stage& stage, const finite_volume::Strip& strip, int y) const;
    [[nodiscard]] Volumes volumes_of_row(int y) const;
    void rate_row(const Water& water, const finite_volume::Strip& strip, int y);

    WaterDomain domain_;
    double gravity_;
    bool manning_;
    bool planes_;                       // along shores
    double steepness_;                  // of the limiter
    double even_friction_;              // as Grid friction_
    Grid friction_;                     // C_f, or g n² of Manning's law; empty: even
    const Grid* rain_ = nullptr;        // m/s, instead of the even rain
    std::vector<double> friction_row_;  // of an even one
    std::vector<double> rain_row_;
    WorkerPool& pool_;
    int nx_ = 0;
    int ny_ = 0;
    Water between_;                             // after the first stage
    Water later_;                               // after the second of three
    std::vector<std::vector<Outlet>> outlets_;  // of each row
    std::unique_ptr<WetTiles> tiles_;           // of the grid's size
    std::vector<double> row_rates_;             // of the water that the last step left, 1/s
    double left_ = 0.0;
    CompensatedSum left_with_flow_;  // where edges have stretches, over which much flows
    CompensatedSum entered_;
    FaceFlows* flows_ = nullptr;                // where they are recorded
    WatchedFaces* watched_ = nullptr;           // by gauges
    double time_ = 0.0;                         // of the discharges and levels at the edges, s
    std::unique_ptr<WaterEdges> edges_;         // of the grid's size
    std::unique_ptr<ShorePlanes> shores_;       // likewise, where shores have planes
    std::vector<finite_volume::Strip> strips_;  // one a thread
};

}  // namespace fumon
