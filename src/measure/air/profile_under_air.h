#pragma once

#include <limits>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

/// The bed under a section, as its measures take it.
struct ProfileUnderAir {
    std::vector<double> heights;  ///< metres, one a column
    std::vector<int> lowest_air;  ///< the first node above the bed in each column, nz where none is
    int waves = 0;                ///< the strongest wave number of the profile; 0 where it is level
    double wavelength = std::numeric_limits<double>::quiet_NaN();  ///< W/k, metres
    double phase = std::numeric_limits<double>::quiet_NaN();       ///< of that wave, see StressFit
    double crest =
        std::numeric_limits<double>::quiet_NaN();  ///< its first crest from x = 0, metres

    /// How far a place lies downwind of the nearest crest, metres: above 0 over the lee side, below
    /// over the stoss side.
    [[nodiscard]] double from_crest(double x) const;
};

/// A node is above the bed where z = k·dz exceeds the bed's height by more than 1e-6·dz. The crests
/// are those of the profile's strongest Fourier component, and a bed without one (its range below
/// 1e-9 of its height) has none. `nodes` is the section's nz. The snapshot has a section and its
/// bed a single row.
ProfileUnderAir profile_under_air(const Snapshot& snapshot, int nodes);

}  // namespace fumon
