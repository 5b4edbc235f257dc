#pragma once

#include <cstdint>

/// What hops that all read the row before have in common, as loops over vectors. Rows have `count`
/// cells.
namespace fumon::hop_vectors {

/// The cell of a row of `nx` that each random word picks: the upper half of word · nx. Returns
/// whether a lower half is below `biased`.
bool pick_cells(const std::uint32_t* words, std::uint32_t nx, std::uint32_t biased, int count,
                std::int32_t* cells);

/// tanh(factor · (right − left)).
void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out);

/// Lengths scale · (e^(rate · in) − 1). A loop by itself: the longer a loop, the fewer of its
/// rounds a processor works on at once, and their chains of operations are long.
void exponential_lengths(const double* in, double scale, double rate, int count, double* out);

/// How much a hop carries: `base`, plus `slope_factor` · the slope's tanh, none below 0; no more
/// than the height where `limited`; none in the shadow of a higher cell upwind.
struct AmountLaw {
    double base = 0.0;
    double slope_factor = 0.0;
    bool limited = false;
    bool from_sand_only = false;         ///< none from a height of 0 or below
    const double* slope_tanh = nullptr;  ///< of the cells; null: `base` alone counts
    const double* upwind = nullptr;      ///< heights of the cells upwind; null: no shadow
};

/// Where sand is after it has left, and where it is to land: on a row of `width` cells that goes
/// round.
struct Departures {
    int width;
    const std::int32_t* from;  ///< the cells; null: all of the row, one after the other
    double* after;             ///< height less what left
    double* amount;            ///< what lands at the nearer cell
    double* far_amount;        ///< what lands at the one beyond it; null: all lands at one
    std::int32_t* to;          ///< the nearer cell
};

/// Departures by hops of a length, sites, that is cut to [0, 2^30], NaN too, and then has
/// `to_nearest` added and its fraction cut off, or split where there are far amounts.
/// Of length base + factor · in.
void hop_linearly(const double* height, const double* in, double base, double factor,
                  double to_nearest, const AmountLaw& amount, int count, const Departures& out);

/// Of length base + trunc(factor · in), the term cut likewise.
void hop_linearly_truncated(const double* height, const double* in, double base, double factor,
                            double to_nearest, const AmountLaw& amount, int count,
                            const Departures& out);

}  // namespace fumon::hop_vectors
