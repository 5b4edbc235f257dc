#pragma once

#include "base/grid.h"

namespace fumon {

/// The thin plate of least bending ∬ f_xx² + 2 f_xy² + f_yy² that lies within `heights` ± `freedom`
/// on every cell, free at the grid's edges and beside cells without data (1 in `nodata`, which may
/// be empty), which keep their heights. By projected relaxation from coarse cells to fine ones, a
/// fixed number of times on each, always in the same order.
Grid bounded_plate(const Grid& heights, const Grid& freedom, const Mask& nodata, double dx,
                   double dy);

}  // namespace fumon
