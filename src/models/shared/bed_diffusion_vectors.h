#pragma once

#include <cstddef>

namespace fumon::bed_diffusion {

/// here + change + r δ²_y here: a row and its neighbours.
void explicit_y(const double* south, const double* here, const double* north, const double* change,
                double r, int count, double* out);

/// to += factor · values.
void add_multiple(const double* values, double factor, int count, double* to);

/// Lines that lie across rows, such as DiffusionLine solves.
struct Lines {
    double r;
    int count;              ///< of their cells
    const double* inverse;  ///< of the pivots
    const double* closing;  ///< of periodic lines, or null
    double closing_weight;
    double closing_end;
};

/// Rows of a field, `stride` apart.
struct Rows {
    const double* first;
    std::ptrdiff_t stride;
};

/// `to` = (1 − r δ²_y)⁻¹ (1 + r_x δ²_x) `from` in `width` columns; `from` can be read a cell past
/// either end. `scratch` holds as many cells.
void cross_rows(const Rows& from, double r_x, const Lines& lines, int width, double* scratch,
                double* to, std::ptrdiff_t to_stride);

/// `to` = (1 + r_x δ²_x) of a row.
void explicit_x(const double* from, double r_x, int count, double* to);

}  // namespace fumon::bed_diffusion
