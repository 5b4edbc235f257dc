#pragma once

#include <cstdint>

/// Creep as loops over vectors.
namespace fumon::creep_vectors {

/// creep_row() of cells 1 … count of rows that start one cell to the west of them.
void creep_inside(const double* south, const double* here, const double* north, double rate,
                  int count, double* after);

/// Bit x of marks is 1 where cell x of `count` is higher than its eight neighbours, and at the
/// first and the last cell. `sides` and `column` are scratch for `count` + 2 values each.
void mark_maxima(const double* south, const double* here, const double* north, int count,
                 double* sides, double* column, std::uint64_t* marks);

}  // namespace fumon::creep_vectors
