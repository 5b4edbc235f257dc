#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "models/water/edge_flow.h"
#include "models/water/gully_parameters.h"
#include "models/water/kernels/finite_volume_vectors.h"
#include "models/water/kernels/limited_slope_vectors.h"
#include "models/water/kernels/mean_vectors.h"
#include "models/water/kernels/speed_bound_vectors.h"
#include "models/water/kernels/update_vectors.h"
#include "models/water/shore_planes.h"
#include "models/water/water_settings.h"

namespace fumon::finite_volume {

using Side = GridSide;

/// What a thread holds while it walks up a block of columns: the last four rows of cells, slopes,
/// fluxes and shares, so that they stay in the cache from one kernel to the next. Each row goes on
/// three cells beyond both ends of the block.
class Strip {
  public:
    static constexpr int margin = 3;  ///< cells beyond the block that its update reads
    static constexpr int widest_block = widest_update;

    Strip(StoppingSteps steps, const SlopeLimits& limits, ShoreCells shores)
        : steps_(steps),
          limits_(limits),
          partly_wet_(shores != ShoreCells::whole),
          hold_means_(shores == ShoreCells::planes),
          values_(static_cast<std::size_t>(fields) * kept * stride) {}

    /// Starts a block of `count` columns from column `first_x` on. Where `edge_west` or
    /// `edge_east`, cells beyond it pay for what comes in there.
    void start(int first_x, int count, bool edge_west = false, bool edge_east = false);

    [[nodiscard]] int first_x() const { return first_x_; }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int padded() const { return count_ + 2 * margin; }

    [[nodiscard]] double* depth(int y) { return row(0, y); }
    [[nodiscard]] double* surface(int y) { return row(1, y); }
    [[nodiscard]] double* velocity_x(int y) { return row(2, y); }
    [[nodiscard]] double* velocity_y(int y) { return row(3, y); }
    [[nodiscard]] double* inside(int y) { return row(4, y); }

    /// Fluxes through the east and west faces of row y.
    void compute_x_fluxes(int y, double gravity);
    /// Slopes northward of row y, whose neighbours are loaded.
    void compute_y_slopes(int y);
    /// Fluxes through the faces between row y and the one north of it.
    void compute_y_fluxes(int y, double gravity);
    /// What rows of cells that may be partly wet are bounded by; nothing for others.
    void compute_invariants(int y, double gravity);
    /// How fast thin water of row y may become, where the rows beside it have theirs.
    void compute_speed_bounds(int y, const BoundFactors& factors);
    /// Lets the water of a cell become as fast as it will.
    void free_speed(int x, int y);
    /// Cuts the fluxes of row y, and of the faces south of it, to what the cells can pay; cells of
    /// a row `beyond` an edge over which water comes in pay it all.
    void cut_fluxes(int y, double dt_dx, double dt_dy, bool beyond);

    /// The water of padded cell k of row y at its face on that side, as reconstructed.
    [[nodiscard]] EdgeWater at_face(int k, int y, Side side) const;
    /// Puts another flux through that face.
    void set_flux(int k, int y, Side side, const EdgeFlux& flux, double depth, double gravity);
    /// Puts other fluxes through faces toward the east of cells of row y; `shift` is added to x.
    void set_x_fluxes(int y, const std::vector<ShorePlanes::Face>& faces, int shift);
    /// … and toward the north.
    void set_y_fluxes(int y, const std::vector<ShorePlanes::Face>& faces, int shift);
    /// Bounds speeds in row y, at any depth, beside cells of a shore in that row or the next.
    void bound_speeds_beside(int y, const std::vector<ShorePlanes::Slope>& shore);
    /// Gives the surface of cells of row y other slopes.
    void set_slopes(int y, const std::vector<ShorePlanes::Slope>& slopes);
    /// What the update of row y's own cells reads, without the step's start.
    [[nodiscard]] UpdateInput update_input(int y);

    /// Water through the side of a cell, outward, per metre, m²/s.
    [[nodiscard]] double outward(int x, int y, Side side) const;

  private:
    static constexpr int fields = 37;
    static constexpr int kept = 4;  // rows; a power of two
    static constexpr int stride = widest_block + 2 * margin + 2;

    enum Kind {
        cells = 0,
        x_slopes = 5,
        y_slopes = 10,
        x_fluxes = 15,
        y_fluxes = 19,
        shares = 23,
        bounds = 24,
        invariants = 26,
        x_means = 27,
        y_means = 32
    };

    [[nodiscard]] std::size_t place(int field, int y) const {
        const auto slot = static_cast<std::size_t>(y & (kept - 1));
        return (static_cast<std::size_t>(field) * kept + slot) * stride;
    }
    double* row(int field, int y) { return values_.data() + place(field, y); }
    [[nodiscard]] static Kind slopes_across(Side side) {
        return side == Side::west || side == Side::east ? x_slopes : y_slopes;
    }
    [[nodiscard]] const double* row(int field, int y) const {
        return values_.data() + place(field, y);
    }
    void compute_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                        const HalfSlopes& out, int count) const;
    void set_fluxes(Kind kind, int y, const std::vector<ShorePlanes::Face>& faces, int shift);
    [[nodiscard]] CellRow across_x(int y, int from);
    [[nodiscard]] InvariantRow invariant_row(int y, int from);
    [[nodiscard]] CellRow across_y(int y, int from);
    [[nodiscard]] MeanRow means(Kind kind, int y, int from);
    [[nodiscard]] CellRow at_faces(Kind kind, const CellRow& cells, int y, int from);
    /// Half of the surface's slopes, as the cells' own water feels them.
    double* surface_slopes(bool across_x, int y);
    [[nodiscard]] HalfSlopes slopes(Kind kind, int y, int from);
    [[nodiscard]] Fluxes fluxes(Kind kind, int y, int from);

    StoppingSteps steps_;
    SlopeLimits limits_;
    bool partly_wet_;
    bool hold_means_;
    std::vector<double> values_;
    std::array<bool, kept> short_of_water_{};
    int first_x_ = 0;
    int count_ = 0;
    bool edge_west_ = false;
    bool edge_east_ = false;
};

}  // namespace fumon::finite_volume
