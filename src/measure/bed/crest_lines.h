#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// A line of crests, from south to north.
struct CrestLine {
    /// One for each row it passes, its place along x in sites, refined by a parabola. In a periodic
    /// bed a line goes on past the edge, so x may lie outside the box.
    std::vector<double> x;
    int first_y = 0;
    bool closed = false;  ///< comes back to itself round a periodic bed: it has no ends
};

/// The crest lines of a bed and how they end.
struct CrestDefects {
    std::int64_t lines = 0;  ///< crest lines, with and without ends
    /// Ends of crest lines: where a crest runs out, or two crests run into one (a Y-junction),
    /// which is one end of the one that does not go on. An edge dislocation is one end.
    std::int64_t ends = 0;
    double crest_length = 0.0;  ///< of all lines, in sites
    /// Pairs of ends for each site of crest length, 1 / sites: the inverse of the mean length of a
    /// crest where none is closed. The defect density of Werner & Kocurek (1999). NaN without
    /// crests.
    double defect_density = std::numeric_limits<double>::quiet_NaN();
    /// Ends for each area of one wavelength squared, a pure number.
    double ends_per_square_wavelength = std::numeric_limits<double>::quiet_NaN();
};

/// The crest lines of a bed whose waves are about `wavelength` sites long along x (any measure of
/// it; factors of 1.3 do not matter; of separate dunes, rather their length along the wind, lest
/// neighbours be taken for one). The bed is smoothed by a triangular kernel of wavelength/12 sites
/// (half its width at half height) in x and y. A crest of a row is a maximum from which the
/// smoothed row falls on both sides by half the standard deviation of the smoothed bed (about its
/// rows' means or lines) before it rises higher. Crests of neighbouring rows are linked where each
/// is the other's nearest and they lie within half a wavelength. Lines over fewer rows than a
/// quarter of a wavelength are noise and left out. Lines follow from row to row: this fails for
/// crests turned more than about 60 degrees from the normal to the wind, which have no maximum
/// along x.
std::vector<CrestLine> crest_lines(const Grid& bed, bool periodic, double wavelength);

/// Counts what crest_lines finds. Of a bed that is not periodic, ends within half a wavelength of
/// its edges are no defects. All NaN or 0 where the wavelength is NaN, below 3 sites or above nx,
/// and for fewer than 4 rows.
CrestDefects crest_defects(const Grid& bed, bool periodic, double wavelength);

}  // namespace fumon
