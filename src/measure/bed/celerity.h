#pragma once

#include <cstdint>
#include <limits>

#include "base/grid.h"
#include "base/snapshot.h"
#include "base/snapshot_lookup.h"
#include "measure/bed/row_spectrum.h"

namespace fumon {

/// The speed at which a pattern moves along x.
struct Celerity {
    /// Sites a step, positive downwind (+x); NaN where the pattern was not found again.
    double sites_per_step = std::numeric_limits<double>::quiet_NaN();
    /// The correlation of the two beds at that displacement, 1 where the pattern has only moved;
    /// NaN where one of them has no relief along x.
    double correlation = std::numeric_limits<double>::quiet_NaN();
};

/// The displacement between two snapshots of one periodic bed, `steps` apart, from the peak of
/// their circular cross-correlation along x with the rows summed, refined by a parabola (off by
/// less than 0.02 sites where the waves are 8 sites long or more). Of the peaks that reach 0.8 of
/// the highest correlation the one nearest to no displacement counts. So a regular pattern is
/// followed over less than half a wavelength only: one that has moved further is taken for one
/// moved less, or upwind; take snapshots close together. Only a pattern so irregular that its
/// correlation one wave further is below 0.8 is followed over up to half the bed, while it keeps
/// its shape.
/// Not found (NaN) where no peak reaches a correlation of 0.3, as with patterns that have changed
/// in between. Two different speeds, of large and small dunes, come out as that of the greater
/// relief. Throws Error for beds of different size and for steps < 1.
Celerity celerity_along_x(const Grid& earlier, const Grid& later, std::int64_t steps);

/// The same of beds whose rows run along x or were turned so, by the spectra of their rows.
Celerity celerity_of_spectra(const RowSpectra& earlier, const RowSpectra& later,
                             std::int64_t steps);

/// The same along any way, of two snapshots of one periodic bed. Along an axis of a grid of square
/// cells it is celerity_along_x of the turned bed; else displacements of up to half the columns
/// are tried site by site, with heights linear between cells, over all rows or, in large beds,
/// every other, third … of them.
Celerity celerity_along(const Snapshot& earlier, const Snapshot& later,
                        const HorizontalDirection& direction);

}  // namespace fumon
