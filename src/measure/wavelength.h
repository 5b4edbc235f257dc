#pragma once

#include "terrain/grid.h"

namespace fumon {

/// The wavelength of a bed along x, in sites: nx / k, where k is the centroid of the power spectrum
/// along x (summed over the rows, the mean taken off) over its highest bin ± 2. Resolution is well
/// below one bin where the pattern has a clear wavelength. 0 for a bed without relief along x.
/// Needs at least 4 columns (throws Error).
double wavelength_along_x(const Grid& bed);

}  // namespace fumon
