#pragma once

#include <array>
#include <cstddef>

/// Loops over rows side by side (RowBatch), a row a lane.
namespace fumon {

struct RowWaves;

namespace row_batch_vectors {

constexpr std::size_t rows = 8;

/// RowBatch::detrend of nx sites; `squares` takes Σ f² of each row.
void detrend(double* values, std::size_t nx, bool periodic, double* squares);

/// Means of `width` sites side by side, from those that begin with the first site of `widened` to
/// the nx-th; summed from the first, then site by site.
void smooth(const double* widened, std::size_t nx, std::size_t width, double* means);

/// What the waves of rows are found by, and what is left over at their ends.
struct WaveSearch {
    std::array<double, rows> threshold;
    std::array<double, rows> armed;  ///< 1 or 0: in which state a row begins
    std::array<RowWaves*, rows> waves;
    std::array<double, rows> lowest_before;  ///< before the first crossing
    std::array<double, rows> highest_before;
    std::array<double, rows> lowest;  ///< from the last crossing on
    std::array<double, rows> highest;
};

/// Notes the crossings of rows and the reliefs between them; RowWaves::reliefs has room for them.
void find_waves(const double* values, std::size_t nx, WaveSearch& search);

}  // namespace row_batch_vectors

}  // namespace fumon
