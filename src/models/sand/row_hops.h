#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"
#include "models/sand/sand_parameters.h"

namespace fumon {

/// The cells that one row picks in one step, each uniformly random: drawn ahead of the hops, so
/// that another thread can draw the next step's meanwhile.
class Picks {
  public:
    /// `count` cells of a row of `nx` from the stream of (seed, row, step).
    void draw(std::int64_t count, int nx, std::uint64_t seed, std::uint32_t row, std::int64_t step);

    [[nodiscard]] std::int64_t step() const { return step_; }
    [[nodiscard]] std::span<const std::int32_t> cells() const { return cells_; }

  private:
    std::int64_t step_ = -1;
    std::vector<std::uint32_t> words_;
    std::vector<std::int32_t> cells_;
};

/// Saltation within one row. Sand moves along the wind only, so rows are independent: a row after
/// its hops is a function of the row before, and of its random numbers.
///
///     h(x) → h(x) − q,   h(x + L) → h(x + L) + q       (periodic)
///
/// with L and q by SandParameters; no hop is shorter than 0 and none carries less than 0.
class RowHops {
  public:
    RowHops(const SandParameters& parameters, int nx);

    /// Every cell hops once, all reading `before` (Terada 2025, eq. 1). `after` gets the new row.
    void synchronous(std::span<const double> before, std::span<double> after);

    /// Hops one after the other, in place, each from a uniformly random cell if there is sand (Sudo
    /// 2002, appendix A), as many as the picks hold.
    void random_sequential(std::span<double> row, const Picks& picks) const;

    /// The length of a hop from height h on slope s, before landing: sites.
    [[nodiscard]] double length(double height, double slope) const;

  private:
    struct PrecomputedHops;

    void compute_slopes(std::span<const double> before);
    void depart(std::span<const double> before, std::span<double> after);
    void land(std::span<double> after) const;
    void land_split(std::span<double> after) const;
    [[nodiscard]] bool can_precompute() const;
    void precompute_hops(const double* row, std::span<const std::int32_t> cells,
                         PrecomputedHops& hops) const;
    template <bool split>
    void apply_precomputed(double* row, const PrecomputedHops& hops) const;
    void hop_from(double* row, int x) const;

    SandParameters parameters_;
    int nx_;
    double exponential_rate_;   ///< ln(a)·2·h0: L grows as e^(rate·h)
    double exponential_scale_;  ///< (N'x/10)/(a^(2·h0) − 1)
    bool needs_slope_;
    // Of the cells of the row that hops at once.
    std::vector<double> slope_tanh_;
    std::vector<double> length_;  ///< where it is exponential or tabulated
    std::vector<double> upwind_;  ///< heights, where there is a shadow
    std::vector<double> amount_;
    std::vector<double> far_amount_;  ///< where hops are split
    std::vector<std::int32_t> to_;
};

}  // namespace fumon
